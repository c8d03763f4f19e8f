#include "matching/checkpoint/level_vertices.h"

#include "base/error.h"
#include "matching/experiment/level_overrides.h"
#include "matching/output/write_file.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cstring>
#include <fstream>
#include <functional>
#include <iterator>
#include <optional>

namespace shellmatch {

namespace {

std::string head_of(int dimension, std::size_t n_vertices, const std::vector<int>& levels) {
  return fmt::format("dimension {}, {} vertices, levels [{}]\n", dimension, n_vertices, fmt::join(levels, ", "));
}

// The levels that a head names; nothing where it is not one of this dimension and these vertices.
std::optional<std::vector<int>> levels_of(const std::string& head, int dimension, std::size_t n_vertices) {
  std::vector<int> levels;
  for (std::size_t at = head.find('['); at != std::string::npos && levels.size() <= finest_level;
       at = head.find(',', at)) {
    at = head.find_first_not_of(" ", at + 1);
    int level = 0;
    if (at == std::string::npos ||
        std::from_chars(head.data() + at, head.data() + head.size(), level).ec != std::errc())
      return std::nullopt;
    if (level < 1 || level > finest_level) return std::nullopt;
    levels.push_back(level);
  }
  // Written again a head is the same: there is one way to write it.
  const bool is_ascending = std::ranges::adjacent_find(levels, std::greater_equal<>()) == levels.end();
  if (!is_ascending || head != head_of(dimension, n_vertices, levels)) return std::nullopt;
  return levels;
}

}  // namespace

template <int Dim>
void write_level_vertices(std::span<const LevelVertices<Dim>> levels, const std::string& path) {
  std::vector<int> numbers;
  for (const LevelVertices<Dim>& level : levels) numbers.push_back(level.level);
  std::string bytes = head_of(Dim, levels.empty() ? 0 : levels[0].vertices.size(), numbers);
  for (const LevelVertices<Dim>& level : levels)
    bytes.append(reinterpret_cast<const char*>(level.vertices.data()), level.vertices.size() * sizeof(Vec<Dim>));
  write_file(path, bytes);
}

template <int Dim>
std::vector<LevelVertices<Dim>> read_level_vertices(const std::string& path, std::size_t n_vertices) {
  static_assert(sizeof(Vec<Dim>) == Dim * sizeof(double));
  const auto fail = [&] { throw_input_error("{}: does not hold the vertices of levels that this run has made", path); };
  std::ifstream in(path, std::ios::binary);
  if (!in) fail();
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  const std::size_t head_size = bytes.find('\n') + 1, per_level = n_vertices * sizeof(Vec<Dim>);
  if (bytes == head_of(Dim, 0, {})) return {};
  // Where there is no line the head is empty, which is none.
  const std::optional<std::vector<int>> numbers = levels_of(bytes.substr(0, head_size), Dim, n_vertices);
  if (!numbers || bytes.size() != head_size + numbers->size() * per_level) fail();
  std::vector<LevelVertices<Dim>> levels;
  for (const int number : *numbers) {
    LevelVertices<Dim>& level = levels.emplace_back(LevelVertices<Dim>{number, std::vector<Vec<Dim>>(n_vertices)});
    std::memcpy(static_cast<void*>(level.vertices.data()), bytes.data() + head_size + (levels.size() - 1) * per_level,
                per_level);
    if (!std::ranges::all_of(level.vertices, [](const Vec<Dim>& x) { return x.allFinite(); })) fail();
  }
  return levels;
}

SHELLMATCH_2D_3D(write_level_vertices);
SHELLMATCH_2D_3D(read_level_vertices);

}  // namespace shellmatch
