#include "tests/repository/include_rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace shellmatch::repository {

namespace {

struct Include {
  std::string path;
  bool quoted;
};

// The include of a line, read by hand: std::regex takes seconds for a whole tree.
std::optional<Include> include_of(std::string_view line) {
  const auto skip_blanks = [&] { line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size())); };
  skip_blanks();
  if (!line.starts_with('#')) return {};
  line.remove_prefix(1);
  skip_blanks();
  if (!line.starts_with("include")) return {};
  line.remove_prefix(7);
  skip_blanks();
  if (line.empty() || (line[0] != '"' && line[0] != '<')) return {};
  const bool quoted = line[0] == '"';
  const std::size_t end = line.find(quoted ? '"' : '>', 1);
  if (end == std::string_view::npos) return {};
  return Include{std::string(line.substr(1, end - 1)), quoted};
}

template <class Body>
void for_each_include(const SourceTree& tree, Body&& body) {
  for (const auto& [file, lines] : tree.files) {
    if (!is_source(file)) continue;
    for (std::size_t i = 0; i < lines.size(); ++i)
      if (const auto include = include_of(lines[i])) body(file, static_cast<int>(i + 1), *include);
  }
}

// Folder -> the folders that its files may include.
const std::map<std::string_view, std::vector<std::string_view>>& folder_table() {
  static const std::map<std::string_view, std::vector<std::string_view>> table = {
      {"base", {"base"}},
      {"geometry", {"geometry", "base"}},
      {"grid", {"grid", "base"}},
      {"energies", {"energies", "grid", "base"}},
      {"solvers", {"solvers", "base"}},
      {"render", {"render", "geometry", "grid", "base"}},
      {"matching", {"matching", "base", "geometry", "grid", "energies", "solvers", "render"}},
      {"studies", {"studies", "base", "solvers", "render", "matching"}},
      {"apps", {"apps", "base", "geometry", "grid", "energies", "solvers", "render", "matching", "studies"}},
      {"bench", {"bench", "tests", "base", "geometry", "grid", "energies", "solvers", "render", "matching"}},
      {"tests", {"tests", "base", "geometry", "grid", "energies", "solvers", "render", "matching", "studies", "apps"}}};
  return table;
}

// A library, how its includes begin, and the files that are its doors.
struct Door {
  std::string_view library;
  std::vector<std::string_view> begins;
  std::vector<std::string_view> files;
};

const std::vector<Door>& door_table() {
  static const std::vector<Door> table = {
      // The dual numbers alone, without the solvers; hence before the entry for the rest of Ceres; so is the checker.
      {"Ceres' dual numbers", {"ceres/jet.h"}, {"energies/*/*", "solvers/libraries/ceres_*.cpp"}},
      {"Ceres' gradient checker", {"ceres/gradient_checker.h"}, {"matching/derivative_check/ceres_checker.cpp"}},
      {"Ceres", {"ceres/", "glog/"}, {"solvers/libraries/ceres_*.cpp"}},
      {"CHOLMOD", {"cholmod"}, {"solvers/metric/cholmod_*.cpp"}},
      {"CGAL", {"CGAL/", "boost/"}, {"geometry/*/cgal_*.cpp", "geometry/*/cgal_*.h", "bench/own_code/cgal_*.cpp"}},
      {"VTK", {"vtk"}, {"*/*/vtk_*.cpp"}},
      {"NLopt", {"nlopt"}, {"solvers/libraries/nlopt_*.cpp"}},
      {"yaml-cpp", {"yaml-cpp/"}, {"matching/experiment/yaml_*.cpp"}},
      {"nlohmann json", {"nlohmann/"}, {"matching/*/*json*.cpp", "matching/*/json_*.h", "studies/*/json_*.cpp"}},
      {"Embree", {"embree"}, {"render/surfaces/*.cpp", "bench/own_code/embree_*.cpp"}},
      {"xxHash", {"xxhash"}, {"matching/output/xxhash_*.cpp"}},
      {"Cairo", {"cairo"}, {"render/canvas/*.cpp"}},
      {"oneTBB", {"tbb/", "oneapi/"}, {"base/parallel.cpp"}},
      {"CLI11", {"CLI/"}, {"apps/*.cpp"}},
      {"nanoflann", {"nanoflann"}, {"grid/fits/*.cpp"}},
      {"fmt", {"fmt/"}, {"base/error.h", "*/*.cpp", "*/*/*.cpp"}},
      {"Google Benchmark", {"benchmark/"}, {"bench/*.cpp"}},
      {"GoogleTest", {"gtest/", "gmock/"}, {}},
      {"Eigen", {"Eigen/"}, {"*/*.h", "*/*.cpp", "*/*/*.h", "*/*/*.cpp"}},
      {"the operating system", {"sys/"}, {"*/*.cpp", "*/*/*.cpp"}}};
  return table;
}

// Headers that the sources of one door share among themselves. They do show the library's types.
bool is_private_header(std::string_view file) { 
  return matches(file, "geometry/*/cgal_*.h") || matches(file, "matching/*/json_*.h") || matches(file, "studies/*/json_*.h");
}

std::string file_as_header(std::string_view file) {
  return std::string(file.substr(0, file.rfind('.'))) + ".h";
}

}  // namespace

std::vector<Finding> check_include_direction(const SourceTree& tree) {
  std::vector<Finding> findings;
  for_each_include(tree, [&](const std::string& file, int line, const Include& include) {
    const auto rule = folder_table().find(top_folder(file));
    if (!include.quoted || rule == folder_table().end()) return;
    const std::string_view to = top_folder(include.path);
    if (!folder_table().contains(to)) {
      findings.push_back(
          {file, line, fmt::format("\"{}\" is not written from the repository root", include.path)});
    } else if (std::find(rule->second.begin(), rule->second.end(), to) == rule->second.end()) {
      findings.push_back(
          {file, line, fmt::format("{}/ may not include {}/ (\"{}\")", rule->first, to, include.path)});
    } else if (!tree.files.contains(include.path)) {
      findings.push_back({file, line, fmt::format("\"{}\" does not exist", include.path)});
    }
  });
  return findings;
}

std::vector<Finding> check_doors(const SourceTree& tree) {
  std::vector<Finding> findings;
  for_each_include(tree, [&](const std::string& file, int line, const Include& include) {
    const std::string_view folder = top_folder(file);
    if (folder == "tests" || !folder_table().contains(folder)) return;
    if (include.quoted) {
      if (is_private_header(include.path) && !is_private_header(file) &&
          !is_private_header(file_as_header(file)))
        findings.push_back(
            {file, line,
             fmt::format("\"{}\" shows a library's types: only its door may read it", include.path)});
      return;
    }
    for (const Door& door : door_table()) {
      if (std::none_of(door.begins.begin(), door.begins.end(),
                       [&](auto b) { return include.path.starts_with(b); }))
        continue;
      if (std::none_of(door.files.begin(), door.files.end(), [&](auto p) { return matches(file, p); }))
        findings.push_back(
            {file, line, fmt::format("<{}>: {} does not enter here", include.path, door.library)});
      return;
    }
    // What is left has to be the standard library: in headers without a suffix, in sources also C's headers
    // and those of the operating system and the processor.
    const bool standard = include.path.find('/') == std::string::npos &&
                          (include.path.find('.') == std::string::npos ||
                           (file.ends_with(".cpp") && include.path.ends_with(".h")));
    if (!standard)
      findings.push_back(
          {file, line, fmt::format("<{}>: a library without a door in include_rules.cpp", include.path)});
  });
  return findings;
}

}  // namespace shellmatch::repository
