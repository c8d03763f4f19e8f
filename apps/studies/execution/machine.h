#pragma once
/// \file
/// Describes the machine on which a study ran, without its name, and the versions of the software involved.

#include <string>
#include <utility>
#include <vector>

namespace shellmatch {

/// The output of `git describe --always --dirty --tags` at build time; empty outside of a repository.
/// cmake/Revision.cmake writes the definition at every build.
std::string build_revision();

/// "Intel Xeon ..., 2 cores, 8 GB"; counts the cores that this process may use.
std::string machine_text();

/// The number of processors that this process may use.
int n_processors();

/// Load average of the last minute.
double machine_load();

/// Names and versions of the program (with the revision it was built from), the compiler, the libraries and the
/// system's kernel.
std::vector<std::pair<std::string, std::string>> versions();

}  // namespace shellmatch
