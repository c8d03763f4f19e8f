#pragma once
/// \file
/// What `shellmatch --version -v` prints.

#include <string>

namespace shellmatch {

/// The program with its revision, the compiler, the vector units of the code that runs, and each linked library with
/// its version, its licence and what that asks of a distributed program.
std::string versions_text();

}  // namespace shellmatch
