#pragma once
/// \file
/// The repository as a set of text files, for checks of the repository itself.

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace shellmatch::repository {

/// One broken rule, with its place. `line` counts from 1; 0 stands for the whole file.
struct Finding {
  std::string file;
  int line = 0;
  std::string what;
};

/// "file:line: what", one finding per line.
std::string to_text(const std::vector<Finding>& findings);

/// Every text file of a source tree: path relative to the root with '/' -> its lines. Build folders
/// (build, build-*, install, out) and .git are left out, and so are pictures and other binary files.
struct SourceTree {
  std::filesystem::path root;
  std::map<std::string, std::vector<std::string>> files;
};

SourceTree read_tree(const std::filesystem::path& root);

/// Is it a file of C++?
bool is_source(std::string_view file);

/// First folder of a path, "" for a file at the root; of folders within folders that are libraries of their own
/// (matching/render, apps/cohorts) the whole path.
std::string_view top_folder(std::string_view file);

/// Does the path match the pattern, where '*' stands for any characters but '/'?
bool matches(std::string_view file, std::string_view pattern);

}  // namespace shellmatch::repository
