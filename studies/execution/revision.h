#pragma once
/// \file
/// The revision of the sources.

#include <string>

namespace shellmatch {

/// What `git describe --always --dirty` said when the program was built; empty outside of a repository.
/// Its body is written by cmake/Revision.cmake at every build.
std::string build_revision();

}  // namespace shellmatch
