#include "tests/repository/text_rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>

namespace shellmatch::repository {

namespace fs = std::filesystem;

namespace {

bool is_word_character(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-'; }

// The anchor that a heading of Markdown gets: small letters, blanks to hyphens, punctuation dropped.
std::string anchor_of(std::string_view heading) {
  std::string anchor;
  for (const char c : heading.substr(std::min(heading.find_first_not_of("# "), heading.size())))
    if (c == ' ') anchor += '-';
    else if (is_word_character(c)) anchor += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return anchor;
}

bool has_anchor(const std::vector<std::string>& lines, const std::string& anchor) {
  return std::any_of(lines.begin(), lines.end(),
                     [&](const std::string& line) { return line.starts_with("#") && anchor_of(line) == anchor; });
}

// Is there a link of Markdown to `target`, written in `file`? Says what is wrong, "" where nothing is.
std::string fault_of_link(const SourceTree& tree, const std::string& file, std::string_view target) {
  if (target.empty() || target.starts_with("http://") || target.starts_with("https://") ||
      target.starts_with("mailto:"))
    return {};
  const std::size_t hash = target.find('#');
  const fs::path path = hash == 0 ? fs::path(file) : fs::path(file).parent_path() / fs::path(target.substr(0, hash));
  const std::string name = path.lexically_normal().generic_string();
  if (!fs::exists(tree.root / name)) return fmt::format("link to {}, which does not exist", target);
  const auto text = tree.files.find(name);
  if (hash != std::string_view::npos && text != tree.files.end() &&
      !has_anchor(text->second, std::string(target.substr(hash + 1))))
    return fmt::format("link to {}: no such heading", target);
  return {};
}

// Is it the path of a file as this repository has them, "grid/octree/octree.h"?
bool looks_like_file(std::string_view text) {
  static const std::set<std::string_view> folders = {"base",    "geometry", "alignment", "grid", "energies",
                                                     "solvers", "matching", "apps",      "docs", "cmake",
                                                     "configs", "python",   "scripts",   "tests"};
  const std::size_t dot = text.rfind('.');
  return folders.contains(text.substr(0, std::min(text.find('/'), text.size()))) && dot != std::string_view::npos &&
         dot > text.rfind('/') && text.find(' ') == std::string_view::npos;
}

bool names_a_file(const SourceTree& tree, std::string_view pattern) {
  if (pattern.find('*') == std::string_view::npos) return fs::exists(tree.root / fs::path(pattern));
  return std::any_of(tree.files.begin(), tree.files.end(), [&](const auto& f) { return matches(f.first, pattern); });
}

void check_line_of_markdown(const SourceTree& tree, const std::string& file, int number, std::string_view line,
                            std::vector<Finding>& findings) {
  for (std::size_t at = line.find("]("); at != std::string_view::npos; at = line.find("](", at + 2)) {
    const std::size_t end = line.find(')', at);
    if (end == std::string_view::npos) break;
    const std::string fault = fault_of_link(tree, file, line.substr(at + 2, end - at - 2));
    if (!fault.empty()) findings.push_back({file, number, fault});
  }
  for (std::size_t begin = line.find('`'); begin != std::string_view::npos;) {
    const std::size_t end = line.find('`', begin + 1);
    if (end == std::string_view::npos) break;
    const std::string_view code = line.substr(begin + 1, end - begin - 1);
    if (looks_like_file(code) && !names_a_file(tree, code))
      findings.push_back({file, number, fmt::format("`{}` does not exist", code)});
    begin = line.find('`', end + 1);
  }
}

// Names of the packages that a file of CMake asks for with `command`.
std::set<std::string> packages_of(const std::vector<std::string>& lines, std::string_view command) {
  std::set<std::string> names;
  for (const std::string& line : lines) {
    const std::size_t at = line.find(command);
    if (at == std::string::npos) continue;
    const std::size_t begin = at + command.size() + 1;
    names.insert(line.substr(begin, line.find_first_of(" )", begin) - begin));
  }
  return names;
}

}  // namespace

std::vector<Finding> check_lengths(const SourceTree& tree, std::size_t most) {
  std::vector<Finding> findings;
  for (const auto& [file, lines] : tree.files) {
    const bool counts = is_source(file) || file.ends_with("CMakeLists.txt") || file.ends_with(".cmake") ||
                        top_folder(file) == "scripts";
    if (counts && lines.size() > most)
      findings.push_back({file, static_cast<int>(lines.size()), fmt::format("more than {} lines: split it", most)});
  }
  return findings;
}

std::vector<Finding> check_machine_paths(const SourceTree& tree) {
  // Each in two pieces, so that this file does not find itself.
  static const std::vector<std::string> traces = {
      "/wo"
      "rk/",
      "/ho"
      "me/",
      "/ro"
      "ot/",
      "/t"
      "mp/",
      "/Us"
      "ers/",
      "debian"
      ".org",
      "npm"
      "js.",
      "pypi"
      ".org"};
  std::vector<Finding> findings;
  for (const auto& [file, lines] : tree.files)
    for (std::size_t i = 0; i < lines.size(); ++i)
      for (const std::string& trace : traces) {
        const std::size_t at = lines[i].find(trace);
        // "out/tmp/x" is relative; a path of the machine begins at its slash.
        const bool inside = at != std::string::npos && at > 0 && trace[0] == '/' &&
                            (is_word_character(lines[i][at - 1]) ||
                             std::string_view("./})").find(lines[i][at - 1]) != std::string_view::npos);
        if (at != std::string::npos && !inside)
          findings.push_back({file, static_cast<int>(i + 1), fmt::format("'{}' belongs to one machine", trace)});
      }
  return findings;
}

std::vector<Finding> check_links(const SourceTree& tree) {
  std::vector<Finding> findings;
  for (const auto& [file, lines] : tree.files) {
    if (!file.ends_with(".md")) continue;
    bool in_code = false;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (lines[i].starts_with("```")) in_code = !in_code;
      if (!in_code) check_line_of_markdown(tree, file, static_cast<int>(i + 1), lines[i], findings);
    }
  }
  return findings;
}

std::vector<Finding> check_dependencies(const SourceTree& tree) {
  const std::string built = "cmake/Dependencies.cmake", installed = "cmake/ShellmatchConfig.cmake.in";
  // These serve the program, the tests, the benchmarks and the Python module, which nobody links to.
  static const std::set<std::string> not_linked = {"CLI11",  "GTest",     "ITK",     "Python",
                                                   "assimp", "benchmark", "pybind11"};
  const auto lines = tree.files.find(built), config = tree.files.find(installed);
  if (lines == tree.files.end()) return {{built, 0, "does not exist"}};
  if (config == tree.files.end()) return {{installed, 0, "does not exist"}};
  const std::set<std::string> found = packages_of(config->second, "find_dependency");
  std::vector<Finding> findings;
  for (const std::string& name : packages_of(lines->second, "find_package"))
    if (!not_linked.contains(name) && !found.contains(name))
      findings.push_back({installed, 0, fmt::format("{}, which {} finds, is missing", name, built)});
  return findings;
}

}  // namespace shellmatch::repository
