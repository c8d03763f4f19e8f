// FreeSurfer's surfaces, big-endian (https://surfer.nmr.mgh.harvard.edu/fswiki/FileFormats), with what mris_convert --to-scanner does.
#include "geometry/scene/brain_surface.h"

#include <Eigen/LU>

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>

namespace shellmatch {

namespace {

std::uint32_t word(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t k = 0; k < 4; ++k) value = value << 8 | static_cast<unsigned char>(bytes[at + k]);
  return value;
}

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

// tkRegister's axes are those of a volume cut as FreeSurfer cuts all of them, its centre the origin; the scanner's are said in the footer.
void bring_to_scanner(const Footer& footer, MeshFile& mesh) {
  const auto x = vector_of(footer, "xras"), y = vector_of(footer, "yras"), z = vector_of(footer, "zras"), centre = vector_of(footer, "cras");
  const auto valid = footer.fields.find("valid");
  std::string_view is_valid = valid == footer.fields.end() ? std::string_view() : valid->second;
  if (footer.is_in_scanner) return;
  if (next_word(is_valid) != "1" || !x || !y || !z || !centre) {
    mesh.notes.push_back("says nothing of its volume: coordinates taken as they stand, which are those of tkRegister (tkRAS), and not the scanner's");
    return;
  }
  Mat<3> axes, own;
  axes << *x, *y, *z;
  own << -1, 0, 0, 0, 0, 1, 0, -1, 0;
  const Mat<3> turn = axes * own.transpose();
  for (Vec<3>& v : mesh.shape.vertices) v = (turn.isIdentity(1e-6) ? v : Vec<3>(turn * v)) + *centre;
  mesh.notes.push_back(fmt::format("brought from tkRegister's frame to the scanner's: moved by c_ras ({:g}, {:g}, {:g}){}", centre->x(),
      centre->y(), centre->z(),
                                   turn.isIdentity(1e-6) ? "" : " and turned to the axes of its volume"));
}

}  // namespace

MeshFile read_freesurfer(const std::string& path, std::string_view bytes) {
  const auto cut_off = [&] { throw_input_error("{}: cut off, or no surface of FreeSurfer's", path); };
  if (!bytes.starts_with(freesurfer_mark)) throw_input_error("{}: no surface of FreeSurfer's: it does not begin as their files of triangles do",
      path);
  // One line of comment and an empty one.
  std::size_t at = bytes.find("\n\n", freesurfer_mark.size());
  if (at == bytes.npos || bytes.size() - at < 10) cut_off();
  at += 2;
  const std::size_t n_vertices = word(bytes, at), n_faces = word(bytes, at + 4), n_left = (bytes.size() - at - 8) / 12;
  at += 8;
  if (n_vertices > n_left || n_faces > n_left - n_vertices)
    throw_input_error("{}: cut off: it declares {} vertices and {} triangles, which take {} bytes; {} are there", path, n_vertices, n_faces,
        12 * (n_vertices + n_faces), bytes.size() - at);
  MeshFile mesh;
  for (std::size_t i = 0; i < n_vertices; ++i, at += 12)
    add_vertex({path, "vertex", i}, Vec<3>(std::bit_cast<float>(word(bytes, at)), std::bit_cast<float>(word(bytes, at + 4)),
        std::bit_cast<float>(word(bytes, at + 8))), mesh.shape);
  for (std::size_t f = 0; f < n_faces; ++f, at += 12) {
    std::vector<Index> corners;
    for (std::size_t k = 0; k < 3; ++k) add_corner({path, "triangle", f}, static_cast<std::int32_t>(word(bytes, at + 4 * k)), n_vertices, corners);
    mesh.shape.polygons.push_back(std::move(corners));
  }
  bring_to_scanner(read_footer(bytes.substr(at)), mesh);
  mesh.shape.space = Space::ras;
  mesh.unit = "mm";
  return mesh;
}

}  // namespace shellmatch
