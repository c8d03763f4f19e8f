#include <base/options.h>
#include <matching/experiment/options.h>

#include <iostream>

// Asks the installed libraries for something that is known: the paper takes nu in one step per level.
int main() {
  const auto options = shellmatch::profile_defaults(shellmatch::Profile::paper);
  std::cout << shellmatch::enum_name(options.profile) << ": " << options.cascade.nu_substeps << " step per level\n";
  return options.cascade.nu_substeps == 1 ? 0 : 1;
}
