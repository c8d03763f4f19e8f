#pragma once
/// \file
/// One run of the program.

#include <string>

namespace shellmatch {

/// A run of the program in a process and a folder of its own.
struct RunTask {
  std::string name;         ///< unique, valid as a file name
  std::string config;       ///< the experiment as YAML, with absolute paths
  std::string fingerprint;  ///< of all that its result depends on, wherever the files are: a result of another one does
                            ///< not count
};

}  // namespace shellmatch
