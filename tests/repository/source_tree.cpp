#include "tests/repository/source_tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

namespace shellmatch::repository {

namespace fs = std::filesystem;

namespace {

bool is_left_out(const std::string& name, bool at_root) {
  if (name == ".git") return true;
  return at_root && (name == "build" || name.starts_with("build-") || name == "install" || name == "out");
}

// A zero byte within the first lines tells a picture from a text.
bool is_binary(const std::vector<std::string>& lines) {
  return std::any_of(lines.begin(), lines.begin() + std::min<std::ptrdiff_t>(std::ssize(lines), 20),
                     [](const std::string& line) { return line.find('\0') != std::string::npos; });
}

}  // namespace

std::string to_text(const std::vector<Finding>& findings) {
  std::string text;
  for (const Finding& f : findings) text += fmt::format("{}:{}: {}\n", f.file, f.line, f.what);
  return text;
}

SourceTree read_tree(const fs::path& root) {
  SourceTree tree{root, {}};
  for (auto it = fs::recursive_directory_iterator(root); it != fs::recursive_directory_iterator(); ++it) {
    if (is_left_out(it->path().filename().string(), it.depth() == 0)) {
      it.disable_recursion_pending();
      continue;
    }
    if (!it->is_regular_file()) continue;
    std::ifstream in(it->path());
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    if (!is_binary(lines)) tree.files[fs::relative(it->path(), root).generic_string()] = std::move(lines);
  }
  return tree;
}

bool is_source(std::string_view file) { return file.ends_with(".h") || file.ends_with(".cpp"); }

std::string_view top_folder(std::string_view file) {
  for (const std::string_view library : {"geometry/statistics", "matching/render", "matching/page", "apps/studies",
                                         "apps/cohorts", "docs/examples", "tests/bench"})
    if (file.starts_with(library) && file.size() > library.size() && file[library.size()] == '/')
      return file.substr(0, library.size());
  const std::size_t slash = file.find('/');
  return slash == std::string_view::npos ? std::string_view{} : file.substr(0, slash);
}

bool matches(std::string_view file, std::string_view pattern) {
  if (pattern.empty()) return file.empty();
  if (pattern.front() != '*')
    return !file.empty() && file.front() == pattern.front() && matches(file.substr(1), pattern.substr(1));
  for (std::size_t n = 0;; ++n) {
    if (matches(file.substr(n), pattern.substr(1))) return true;
    if (n == file.size() || file[n] == '/') return false;
  }
}

}  // namespace shellmatch::repository
