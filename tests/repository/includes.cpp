#include "tests/repository/includes.h"

#include <algorithm>
#include <optional>

namespace shellmatch::repository {

namespace {

struct Directive {
  std::string path;
  bool quoted;
};

// Parsed by hand: std::regex takes seconds for a whole tree.
std::optional<Directive> directive_of(std::string_view line) {
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
  return Directive{std::string(line.substr(1, end - 1)), quoted};
}

}  // namespace

std::vector<Include> includes_of(const SourceTree& tree) {
  std::vector<Include> includes;
  for (const auto& [file, lines] : tree.files) {
    if (!is_source(file)) continue;
    for (std::size_t i = 0; i < lines.size(); ++i)
      if (const auto directive = directive_of(lines[i]))
        includes.push_back({file, static_cast<int>(i + 1), directive->path, directive->quoted});
  }
  return includes;
}

const std::map<std::string_view, std::vector<std::string_view>>& folder_table() {
  static const std::map<std::string_view, std::vector<std::string_view>> table = {
      {"base", {"base"}},
      {"geometry", {"geometry", "base"}},
      {"geometry/statistics", {"geometry/statistics", "base"}},
      {"alignment", {"alignment", "geometry", "base"}},
      {"grid", {"grid", "base"}},
      {"energies", {"energies", "grid", "base"}},
      {"solvers", {"solvers", "base"}},
      {"matching/render", {"matching/render", "geometry", "grid", "base"}},
      {"matching", {"matching", "base", "geometry", "alignment", "grid", "energies", "solvers", "matching/render"}},
      {"apps/studies", {"apps/studies", "base", "solvers", "matching/render", "matching"}},
      {"apps/cohorts",
       {"apps/cohorts", "base", "geometry/statistics", "geometry", "matching/render", "matching", "apps/studies"}},
      {"apps",
       {"apps", "base", "geometry/statistics", "geometry", "alignment", "grid", "energies", "solvers",
        "matching/render", "matching", "apps/studies", "apps/cohorts"}},
      {"python",
       {"python", "base", "geometry/statistics", "geometry", "alignment", "grid", "energies", "solvers", "matching"}},
      {"docs/examples",
       {"docs/examples", "base", "geometry/statistics", "geometry", "alignment", "grid", "energies", "solvers",
        "matching/render", "matching"}},
      {"tests/bench",
       {"tests/bench", "tests", "base", "geometry/statistics", "geometry", "alignment", "grid", "energies", "solvers",
        "matching/render", "matching"}},
      {"tests",
       {"tests", "base", "geometry/statistics", "geometry", "alignment", "grid", "energies", "solvers",
        "matching/render", "matching", "apps/studies", "apps/cohorts", "apps", "docs/examples"}}};
  return table;
}

}  // namespace shellmatch::repository
