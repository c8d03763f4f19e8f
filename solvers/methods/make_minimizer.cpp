#include "base/error.h"
#include "solvers/libraries/ceres_minimizer.h"
#include "solvers/libraries/nlopt_minimizer.h"
#include "solvers/methods/fletcher_reeves.h"
#include "solvers/methods/lbfgs.h"
#include "solvers/methods/newton.h"
#include "solvers/solver_options.h"

#include <algorithm>

namespace shellmatch {

namespace {

// Throws for the first number that is out of its range. Options from YAML have been checked before; those set
// by a program have not.
struct RangeCheck {
  std::string path;

  template <class T>
  void operator()(std::string_view name, const T& value, const OptionInfo& info) {
    const std::string key = path + "." + std::string(name);
    if constexpr (std::is_arithmetic_v<T>) {
      if (!in_range(static_cast<double>(value), info))
        throw_input_error("{} = {} is out of range ({}): {}", key, value, range_text(info), info.meaning);
    } else if constexpr (requires(RangeCheck & r) { T::describe(value, r); }) {
      RangeCheck inner{key};
      T::describe(value, inner);
    }
  }
};

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& w : words) text += (text.empty() ? "" : ", ") + w;
  return text;
}

[[noreturn]] void refuse_name(const std::string& option, const std::string& name, std::vector<std::string> names) {
  const std::string nearest = nearest_word(name, names);
  throw_input_error("{}: there is no method '{}'{}; choose one of {}", option, name,
                    nearest.empty() ? "" : ", did you mean '" + nearest + "'?", joined(names));
}

void check_fallback(const SolverOptions& options) {
  std::vector<std::string> names = minimizer_names();
  names.emplace_back("auto");
  for (const std::string& name : options.fallback)
    if (std::find(names.begin(), names.end(), name) == names.end()) refuse_name("solver.fallback", name, names);
}

}  // namespace

std::vector<std::string> minimizer_names() {
  std::vector<std::string> names{"fletcher_reeves", "lbfgs", "newton"};
  for (const auto& [method, name] : EnumNames<CeresMethod>::names) names.emplace_back(name);
  for (const auto& [method, name] : EnumNames<NloptMethod>::names) names.emplace_back(name);
  return names;
}

std::unique_ptr<Minimizer> make_minimizer(const SolverOptions& options) {
  RangeCheck check{"solver"};
  SolverOptions::describe(options, check);
  check_fallback(options);
  if (options.name == "fletcher_reeves") return std::make_unique<FletcherReeves>(options.fletcher_reeves);
  if (options.name == "lbfgs") return std::make_unique<Lbfgs>(options.lbfgs);
  if (options.name == "newton") return std::make_unique<Newton>(options.newton);
  for (const auto& [method, name] : EnumNames<CeresMethod>::names)
    if (options.name == name) return std::make_unique<CeresMinimizer>(method, options.ceres);
  for (const auto& [method, name] : EnumNames<NloptMethod>::names)
    if (options.name == name) return std::make_unique<NloptMinimizer>(method);

  refuse_name("solver.name", options.name, minimizer_names());
}

}  // namespace shellmatch
