// Stereolithography files, text and binary. Both list separate triangles.
#include "geometry/mesh_text/read_mesh_formats.h"

#include <bit>
#include <cstdint>
#include <cstring>
#include <vector>

namespace shellmatch {
namespace {

constexpr std::size_t header_size = 84, triangle_size = 50;

// Merges corners with equal coordinates: a table of vertices, at most half full, in which those of equal places follow
// each other.
class Welder {
 public:
  explicit Welder(OriginalShape<3>& shape) : shape_(shape), table_(1024, no_index) {}
  Index vertex(const FilePosition& place, Vec<3> x) {
    stop_check_();
    x.array() += 0.0;  // maps -0 to 0
    const std::size_t at = slot_of(x);
    if (table_[at] != no_index) return table_[at];
    const auto number = static_cast<Index>(shape_.vertices.size());
    add_vertex(place, x, shape_);
    table_[at] = number;
    if (2 * shape_.vertices.size() > table_.size()) grow();
    return number;
  }

 private:
  // Where the vertex is, or has its free place.
  std::size_t slot_of(const Vec<3>& x) const {
    std::uint64_t hash = 0;
    for (const double v : x) {
      hash = (hash ^ std::bit_cast<std::uint64_t>(v)) * 0x9E3779B97F4A7C15u;
      hash ^= hash >> 29;
    }
    std::size_t at = hash & (table_.size() - 1);
    while (table_[at] != no_index && shape_.vertices[table_[at]] != x) at = (at + 1) & (table_.size() - 1);
    return at;
  }

  void grow() {
    table_.assign(2 * table_.size(), no_index);
    for (std::size_t v = 0; v < shape_.vertices.size(); ++v)
      table_[slot_of(shape_.vertices[v])] = static_cast<Index>(v);
  }

  OriginalShape<3>& shape_;
  std::vector<Index> table_;  // its size is a power of two
  StopCheck stop_check_;
};

std::uint32_t declared_triangles(std::string_view bytes) {
  std::uint32_t n = 0;
  std::memcpy(&n, bytes.data() + 80, sizeof n);
  return n;
}

MeshFile read_binary(const std::string& path, std::string_view bytes) {
  MeshFile mesh;
  const std::size_t n = declared_triangles(bytes), needed = header_size + triangle_size * n;
  if (bytes.size() < needed)
    throw_input_error(
        "{}: cut off, or not an STL file: the header declares {} triangles, which take {} bytes; the file "
        "has {}",
        path, n, needed, bytes.size());
  if (bytes.size() > needed)
    mesh.notes.push_back(counted(bytes.size() - needed, "byte", "bytes") + " after the last triangle ignored");
  Welder welder(mesh.shape);
  for (std::size_t t = 0; t < n; ++t) {
    std::vector<Index> triangle;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      float x[3];
      std::memcpy(x, bytes.data() + header_size + triangle_size * t + 12 * (corner + 1), sizeof x);
      triangle.push_back(welder.vertex({path, "triangle", t}, Vec<3>(x[0], x[1], x[2])));
    }
    mesh.shape.polygons.push_back(std::move(triangle));
  }
  return mesh;
}

// One "facet normal a b c" with its loop of vertices, up to "endfacet".
std::vector<Index> read_facet(LineReader& lines, Welder& welder) {
  std::vector<Index> polygon;
  while (lines.next()) {
    std::string_view rest = lines.line();
    const std::string_view keyword = next_word(rest);
    if (equals_ignoring_case(keyword, "vertex")) {
      Vec<3> x;
      for (int k = 0; k < 3; ++k) x[k] = lines.number_of(rest, "a coordinate of a vertex");
      polygon.push_back(welder.vertex({lines.path(), "line", lines.number()}, x));
    } else if (equals_ignoring_case(keyword, "endfacet")) {
      if (polygon.size() != 3) lines.fail("a facet of an STL file has three vertices, this one has {}", polygon.size());
      return polygon;
    } else if (!equals_ignoring_case(keyword, "outer") && !equals_ignoring_case(keyword, "endloop")) {
      lines.fail("unknown word in a facet; 'outer loop', 'vertex', 'endloop' or 'endfacet' should stand here");
    }
  }
  throw_input_error("{}: cut off: the file ends within facet (line {})", lines.path(), lines.number());
}

MeshFile read_text(const std::string& path, std::string_view bytes) {
  MeshFile mesh;
  LineReader lines(path, bytes, '\0');
  Welder welder(mesh.shape);
  bool open = false;
  std::size_t n_solids = 0;
  while (lines.next()) {
    std::string_view rest = lines.line();
    const std::string_view keyword = next_word(rest);
    if (equals_ignoring_case(keyword, "facet") && open) {
      mesh.shape.polygons.push_back(read_facet(lines, welder));
    } else if (equals_ignoring_case(keyword, "solid") && !open) {
      open = true;
      ++n_solids;
    } else if (equals_ignoring_case(keyword, "endsolid") && open) {
      open = false;
    } else {
      lines.fail("'solid', 'facet' or 'endsolid' should stand here");
    }
  }
  if (open) throw_input_error("{}: cut off: 'endsolid' is missing at the end (line {})", path, lines.number());
  if (n_solids > 1) mesh.notes.push_back(fmt::format("{} solids read as one shape, without their names", n_solids));
  return mesh;
}

}  // namespace

MeshFile read_stl(const std::string& path, std::string_view bytes) {
  // Some binary files start with "solid" as well, so the size is checked first.
  const bool has_header = bytes.size() >= header_size;
  if (has_header && header_size + triangle_size * std::size_t{declared_triangles(bytes)} == bytes.size())
    return read_binary(path, bytes);
  std::string_view rest = bytes.starts_with("\xEF\xBB\xBF") ? bytes.substr(3) : bytes;
  const std::string_view word = next_word(rest, " \t\r\n\v\f");
  const bool text = equals_ignoring_case(word, "solid") && bytes.find('\0') == bytes.npos;
  if (text) return read_text(path, bytes);
  if (!has_header)
    throw_input_error(
        "{}: cut off, or not an STL file: it neither starts with 'solid' nor has a binary header of {} bytes", path,
        header_size);
  return read_binary(path, bytes);
}

}  // namespace shellmatch
