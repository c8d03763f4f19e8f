#pragma once
/// \file
/// The include directives of a source tree.

#include "tests/repository/source_tree.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace shellmatch::repository {

struct Include {
  std::string file;  ///< that holds the directive
  int line;          ///< counted from 1
  std::string path;  ///< as written between quotes or angle brackets
  bool quoted;
};

/// All include directives, by file and line.
std::vector<Include> includes_of(const SourceTree& tree);

/// Folder at the root -> the folders that its files may include, itself among them.
const std::map<std::string_view, std::vector<std::string_view>>& folder_table();

}  // namespace shellmatch::repository
