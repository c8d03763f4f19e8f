#pragma once
/// \file
/// On what a study ran: the machine, without its name, and the versions of all that took part.

#include <string>
#include <utility>
#include <vector>

namespace shellmatch {

/// "Intel Xeon ..., 2 cores, 8 GB": the cores that this process may use.
std::string machine_text();

/// Number of processors that this process may use.
int n_processors();

/// Mean number of processes that wanted to run during the last minute.
double machine_load();

/// Name and version: the program with the revision it was built from, the compiler, the libraries, the
/// system's kernel.
std::vector<std::pair<std::string, std::string>> versions();

}  // namespace shellmatch
