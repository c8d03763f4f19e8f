#pragma once
/// \file
/// The revision of the sources.

#include <string>

namespace shellmatch {

/// The output of `git describe --always --dirty --tags` at build time; empty outside of a repository.
/// cmake/Revision.cmake writes the definition at every build.
std::string build_revision();

}  // namespace shellmatch
