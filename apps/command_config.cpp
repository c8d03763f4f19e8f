#include "apps/commands.h"
#include "matching/experiment/yaml_options.h"

#include <iostream>

namespace shellmatch {

void execute(const ConfigCommand& command) {
  std::vector<Override> overrides;
  if (!command.profile.empty()) overrides.push_back({"profile", command.profile, "--profile " + command.profile});
  print_reference(std::cout, make_experiment(overrides).profile,
                  command.markdown ? ReferenceFormat::markdown : ReferenceFormat::yaml);
}

void execute(const PrintCommand& command) { std::cout << command.text; }

}  // namespace shellmatch
