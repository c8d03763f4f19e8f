// In place of sources that readers are linked with and whose work is no reading: they would take longer to compile than
// all readers.
#include "base/error.h"
#include "geometry/generate/exact_shape.h"
#include "geometry/generate/generate_shape.h"
#include "matching/input/shape_source.h"
#include "solvers/minimizer.h"
#include "solvers/solver_options.h"

#include <algorithm>
#include <stdexcept>

namespace shellmatch {

// A volume may be two files, of which readers of options open none.
std::vector<std::string> files_of_shape(const std::string& source) { return {source}; }

// Of make_minimizer() the readers of options use the refusals only.
std::vector<std::string> minimizer_names() {
  return {"fletcher_reeves", "lbfgs", "newton", "ceres_lbfgs", "nlopt_lbfgs"};
}

std::unique_ptr<Minimizer> make_minimizer(const SolverOptions& options) {
  const auto names = minimizer_names();
  if (std::ranges::find(names, options.name) == names.end())
    throw_input_error("solver.name: there is no method '{}'", options.name);
  for (const std::string& name : options.fallback)
    if (name != "auto" && std::ranges::find(names, name) == names.end())
      throw_input_error("solver.fallback: there is no method '{}'", name);
  return nullptr;
}

[[noreturn]] static void never_called() { throw std::logic_error("readers generate no shapes"); }

// Whoever names a shape has it generated to see whether it exists: here a few do.
AnyOriginal generate_shape(std::string_view name, std::string_view, double, const GeneratorParameters&) {
  for (const std::string_view known : {"circle", "blob", "leaf", "star"})
    if (name == known) return OriginalShape<2>();
  throw_input_error("there is no shape '{}'", name);
}
AnyKnownPositions known_positions(std::string_view, std::string_view, std::string_view) { never_called(); }
std::optional<AnyExactShape> exact_shape(std::string_view, std::string_view) { never_called(); }

}  // namespace shellmatch
