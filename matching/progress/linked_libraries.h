#pragma once
/// \file
/// What the program is linked to or takes code from, as CMake found it (cmake/LinkedLibraries.cmake).

#include <string>
#include <vector>

namespace shellmatch {

struct LinkedLibrary {
  std::string name, version;
  std::string licence;  ///< as in docs/licences.md, which says more
  std::string binds;    ///< what it asks of a distributed program: a licence, "notice", "its own files only" or "no"
};

/// All of them, those that bind most first.
const std::vector<LinkedLibrary>& linked_libraries();

}  // namespace shellmatch
