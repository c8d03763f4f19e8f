// The module shellmatch._core, on which the package shellmatch (python/shellmatch) is built.

#include "matching/progress/process_info.h"
#include "python/bindings/bindings.h"
#include "python/bindings/errors.h"
#include "python/bindings/inputs.h"
#include "python/bindings/map.h"

PYBIND11_MODULE(_core, module) {
  using namespace shellmatch::python;
  module.doc() = "What the package shellmatch is built on. Its functions expect what that package has checked.";
  module.attr("version") = shellmatch::program_version();
  translate_errors();
  bind_shape_input(module);
  bind_map(module);
  bind_match(module);
  bind_problem(module);
  bind_statistics(module);
}
