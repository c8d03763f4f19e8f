#include "tests/repository/structure_rules.h"

#include "tests/repository/includes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

namespace shellmatch::repository {

namespace {

std::string folder_of(const std::string& file) {
  const std::size_t slash = file.rfind('/');
  return slash == std::string::npos ? std::string{} : file.substr(0, slash);
}

std::string unit_of(const std::string& file) { return file.substr(0, file.rfind('.')); }

/// Node -> the nodes that it includes, each with the first include directive that says so.
using Graph = std::map<std::string, std::map<std::string, Include>>;

/// The graph whose nodes are name(file), without edges from a node to itself. Only own files that exist count.
template <class Name, class Keep>
Graph include_graph(const SourceTree& tree, const Name& name, const Keep& keep) {
  Graph graph;
  for (const Include& include : includes_of(tree)) {
    if (!include.quoted || !tree.files.contains(include.path) || !keep(include)) continue;
    const std::string from = name(include.file), to = name(include.path);
    if (from != to) graph[from].emplace(to, include);
  }
  return graph;
}

/// The nodes on a shortest path from `start` back to itself, `start` first; empty where there is none.
std::vector<std::string> shortest_cycle(const Graph& graph, const std::string& start) {
  std::map<std::string, std::string> reached_from;
  std::vector<std::string> queue = {start};
  for (std::size_t next = 0; next < queue.size(); ++next) {
    const auto edges = graph.find(queue[next]);
    if (edges == graph.end()) continue;
    for (const auto& [to, include] : edges->second) {
      if (!reached_from.emplace(to, queue[next]).second) continue;
      queue.push_back(to);
    }
  }
  std::vector<std::string> cycle;
  if (!reached_from.contains(start)) return cycle;
  for (std::string node = reached_from[start]; node != start; node = reached_from[node]) cycle.push_back(node);
  cycle.push_back(start);
  std::reverse(cycle.begin(), cycle.end());
  return cycle;
}

/// All nodes that can be reached from `start`.
std::set<std::string> reachable(const Graph& graph, const std::string& start) {
  std::set<std::string> found;
  std::vector<std::string> open = {start};
  while (!open.empty()) {
    const auto edges = graph.find(open.back());
    open.pop_back();
    if (edges == graph.end()) continue;
    for (const auto& [to, include] : edges->second)
      if (found.insert(to).second) open.push_back(to);
  }
  return found;
}

std::vector<Finding> cycles_of(const Graph& graph) {
  std::vector<Finding> findings;
  std::set<std::string> done;
  for (const auto& [start, edges] : graph) {
    if (done.contains(start)) continue;
    const std::vector<std::string> cycle = shortest_cycle(graph, start);
    if (cycle.empty()) continue;
    for (const std::string& node : reachable(graph, start))
      if (reachable(graph, node).contains(start)) done.insert(node);
    const Include& first = edges.at(cycle[1]);
    findings.push_back(
        {first.file, first.line, fmt::format("a cycle of includes: {} -> {}", fmt::join(cycle, " -> "), start)});
  }
  return findings;
}

}  // namespace

std::vector<Finding> check_unit_cycles(const SourceTree& tree) {
  return cycles_of(include_graph(tree, unit_of, [](const Include&) { return true; }));
}

std::vector<Finding> check_room_sizes(const SourceTree& tree, std::size_t most) {
  std::map<std::string, std::size_t> n_files;
  for (const auto& [file, lines] : tree.files)
    if (is_source(file)) ++n_files[folder_of(file)];
  std::vector<Finding> findings;
  for (const auto& [room, n] : n_files)
    if (n > most) findings.push_back({room, 0, fmt::format("{} sources, more than {}: split it by subject", n, most)});
  return findings;
}

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

std::vector<Finding> check_room_cycles(const SourceTree& tree, const std::vector<std::string_view>& exceptions) {
  return cycles_of(include_graph(tree, folder_of, [&](const Include& include) {
    const std::string_view top = top_folder(include.file);
    return top == top_folder(include.path) && top != "tests" &&
           std::find(exceptions.begin(), exceptions.end(), top) == exceptions.end();
  }));
}

std::vector<Finding> check_test_folders(const SourceTree& tree) {
  static const std::set<std::string_view> mirror_nothing = {"bench",      "faults",  "fuzz",   "install",
                                                            "repository", "studies", "support"};
  std::set<std::string> folders;
  for (const auto& [file, lines] : tree.files)
    for (std::string f = folder_of(file); !f.empty(); f = folder_of(f)) folders.insert(f);
  std::vector<Finding> findings;
  for (const std::string& folder : folders) {
    if (!folder.starts_with("tests/")) continue;
    const std::string mirrored = folder.substr(6);
    const std::string first = mirrored.substr(0, mirrored.find('/'));
    if (!mirror_nothing.contains(first) && !folders.contains(mirrored))
      findings.push_back({folder, 0, fmt::format("there is no folder {} that it tests", mirrored)});
  }
  return findings;
}

}  // namespace shellmatch::repository
