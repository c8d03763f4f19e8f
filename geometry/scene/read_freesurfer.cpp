// FreeSurfer's surfaces, big-endian (https://surfer.nmr.mgh.harvard.edu/fswiki/FileFormats), with what mris_convert
// --to-scanner does.
#include "geometry/scene/brain_surface.h"

#include <Eigen/LU>

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>

namespace shellmatch {

namespace {

constexpr std::string_view triangle_mark = "\xff\xff\xfe", quad_mark = "\xff\xff\xff", new_quad_mark = "\xff\xff\xfd";

std::uint32_t word(std::string_view bytes, std::size_t at, std::size_t length = 4) {
  std::uint32_t value = 0;
  for (std::size_t k = 0; k < length; ++k) value = value << 8 | static_cast<unsigned char>(bytes[at + k]);
  return value;
}

// Of quadrilaterals: their numbers after the mark, coordinates as hundredths in 16 bits or as floats, corners, all
// numbers but these of three bytes.
struct QuadHead {
  std::size_t n_vertices, n_faces, n_bytes;
  bool is_old;
  explicit QuadHead(std::string_view head)
      : n_vertices(word(head, 3, 3)), n_faces(word(head, 6, 3)), n_bytes(0), is_old(head.starts_with(quad_mark)) {
    n_bytes = freesurfer_head + (is_old ? 6 : 12) * n_vertices + 12 * n_faces;
  }
};

// What stands after the triangles, as far as it is understood.
struct Footer {
  bool is_in_scanner = false;                 // useRealRAS
  std::map<std::string, std::string> fields;  // "cras" -> "0 0 0"
};

constexpr std::uint32_t tag_real_ras = 2, tag_geometry = 20;

Footer read_footer(std::string_view rest) {
  Footer footer;
  if (rest.size() >= 8 && word(rest, 0) == tag_real_ras) {
    footer.is_in_scanner = word(rest, 4) == 1;
    rest.remove_prefix(8);
  }
  if (rest.size() < 4 || word(rest, 0) != tag_geometry) return footer;
  rest.remove_prefix(4);
  // "name = values", then other tags, which are not text.
  for (int line = 0; line < 8 && !rest.empty(); ++line) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    std::string_view text = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    const std::size_t equals = text.find('=');
    if (equals == text.npos) break;
    std::string_view name = text.substr(0, equals);
    footer.fields.emplace(next_word(name), text.substr(equals + 1));
  }
  return footer;
}

std::optional<Vec<3>> vector_of(const Footer& footer, const std::string& name) {
  const auto found = footer.fields.find(name);
  if (found == footer.fields.end()) return {};
  std::string_view rest = found->second;
  Vec<3> x;
  for (int k = 0; k < 3; ++k) {
    const std::optional<double> value = to_double(next_word(rest));
    if (!value || !std::isfinite(*value)) return {};
    x[k] = *value;
  }
  return x;
}

// tkRegister's axes are those of a volume cut as FreeSurfer cuts all of them, its centre the origin; the scanner's are
// said in the footer.
void bring_to_scanner(const Footer& footer, MeshFile& mesh) {
  const auto x = vector_of(footer, "xras"), y = vector_of(footer, "yras"), z = vector_of(footer, "zras"),
             centre = vector_of(footer, "cras");
  const auto valid = footer.fields.find("valid");
  std::string_view is_valid = valid == footer.fields.end() ? std::string_view() : valid->second;
  if (footer.is_in_scanner) return;
  if (next_word(is_valid) != "1" || !x || !y || !z || !centre) {
    mesh.notes.push_back(
        "says nothing of its volume: coordinates taken as they stand, which are those of tkRegister (tkRAS), and not "
        "the scanner's");
    return;
  }
  Mat<3> axes, own;
  axes << *x, *y, *z;
  own << -1, 0, 0, 0, 0, 1, 0, -1, 0;
  const Mat<3> turn = axes * own.transpose();
  for (Vec<3>& v : mesh.shape.vertices) v = (turn.isIdentity(1e-6) ? v : Vec<3>(turn * v)) + *centre;
  mesh.notes.push_back(
      fmt::format("brought from tkRegister's frame to the scanner's: moved by c_ras ({:g}, {:g}, {:g}){}", centre->x(),
                  centre->y(), centre->z(), turn.isIdentity(1e-6) ? "" : " and turned to the axes of its volume"));
}

}  // namespace

bool is_freesurfer(std::string_view head, std::uintmax_t size) {
  if (head.starts_with(triangle_mark)) return true;
  if (head.size() < freesurfer_head) return false;
  // Values at vertices (lh.curv) begin as old quadrilaterals do: only the size tells them apart.
  return head.starts_with(new_quad_mark) || (head.starts_with(quad_mark) && QuadHead(head).n_bytes == size);
}

namespace {

MeshFile read_quads(const std::string& path, std::string_view bytes) {
  const QuadHead head(bytes);
  if (head.n_bytes > bytes.size())
    throw_input_error(
        "{}: cut off: it declares {} vertices and {} quadrilaterals, which take {} bytes; the file has {}", path,
        head.n_vertices, head.n_faces, head.n_bytes, bytes.size());
  MeshFile mesh;
  std::size_t at = freesurfer_head;
  const auto coordinate = [&] {
    const std::size_t length = head.is_old ? 2 : 4;
    const std::uint32_t value = word(bytes, at, length);
    at += length;
    return head.is_old ? static_cast<std::int16_t>(value) / 100.0 : static_cast<double>(std::bit_cast<float>(value));
  };
  for (std::size_t i = 0; i < head.n_vertices; ++i) {
    const double x = coordinate(), y = coordinate(), z = coordinate();
    add_vertex({path, "vertex", i}, Vec<3>(x, y, z), mesh.shape);
  }
  for (std::size_t f = 0; f < head.n_faces; ++f, at += 12) {
    std::vector<Index> q;
    for (std::size_t k = 0; k < 4; ++k)
      add_corner({path, "quadrilateral", f}, static_cast<std::int32_t>(word(bytes, at + 3 * k, 3)), head.n_vertices, q);
    // Along the diagonal that FreeSurfer and nibabel take.
    if (q[0] % 2 == 0) mesh.shape.polygons.insert(mesh.shape.polygons.end(), {{q[0], q[1], q[3]}, {q[2], q[3], q[1]}});
    else mesh.shape.polygons.insert(mesh.shape.polygons.end(), {{q[0], q[1], q[2]}, {q[0], q[2], q[3]}});
  }
  bring_to_scanner({}, mesh);
  mesh.shape.space = Space::ras;
  mesh.unit = "mm";
  return mesh;
}

}  // namespace

MeshFile read_freesurfer(const std::string& path, std::string_view bytes) {
  if (bytes.size() >= freesurfer_head && !bytes.starts_with(triangle_mark) &&
      is_freesurfer(bytes.substr(0, freesurfer_head), bytes.size()))
    return read_quads(path, bytes);
  const auto cut_off = [&] { throw_input_error("{}: cut off, or no surface of FreeSurfer's", path); };
  if (!bytes.starts_with(triangle_mark))
    throw_input_error(
        "{}: no surface of FreeSurfer's: it does not begin as their files of triangles or quadrilaterals do", path);
  // One line of comment and an empty one.
  std::size_t at = bytes.find("\n\n", triangle_mark.size());
  if (at == bytes.npos || bytes.size() - at < 10) cut_off();
  at += 2;
  const std::size_t n_vertices = word(bytes, at), n_faces = word(bytes, at + 4), n_left = (bytes.size() - at - 8) / 12;
  at += 8;
  if (n_vertices > n_left || n_faces > n_left - n_vertices)
    throw_input_error("{}: cut off: it declares {} vertices and {} triangles, which take {} bytes; {} are there", path,
                      n_vertices, n_faces, 12 * (n_vertices + n_faces), bytes.size() - at);
  MeshFile mesh;
  for (std::size_t i = 0; i < n_vertices; ++i, at += 12)
    add_vertex({path, "vertex", i},
               Vec<3>(std::bit_cast<float>(word(bytes, at)), std::bit_cast<float>(word(bytes, at + 4)),
                      std::bit_cast<float>(word(bytes, at + 8))),
               mesh.shape);
  for (std::size_t f = 0; f < n_faces; ++f, at += 12) {
    std::vector<Index> corners;
    for (std::size_t k = 0; k < 3; ++k)
      add_corner({path, "triangle", f}, static_cast<std::int32_t>(word(bytes, at + 4 * k)), n_vertices, corners);
    mesh.shape.polygons.push_back(std::move(corners));
  }
  bring_to_scanner(read_footer(bytes.substr(at)), mesh);
  mesh.shape.space = Space::ras;
  mesh.unit = "mm";
  return mesh;
}

}  // namespace shellmatch
