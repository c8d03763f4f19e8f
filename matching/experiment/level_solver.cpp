#include "matching/experiment/level_solver.h"

#include "base/error.h"
#include "matching/experiment/option_text.h"

namespace shellmatch {

SolverOptions solver_at_level(const LevelwiseSolverOptions& options, int level) {
  SolverOptions result = options;
  const OptionNode tree = option_tree(result);
  for (const LevelOverrides::Entry& e : options.levels.entries) {
    if (level < e.first || level > e.last) continue;
    for (const auto& [path, values] : e.settings) {
      const OptionNode* option = find_option(tree, path);
      SHELLMATCH_CHECK(option != nullptr && option->set, "overrides name options of their section");
      option->set(values);
    }
  }
  return result;
}

}  // namespace shellmatch
