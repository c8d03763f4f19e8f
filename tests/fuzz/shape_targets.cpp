#include "base/error.h"
#include "geometry/io/read_points.h"
#include "geometry/mesh_text/read_mesh_formats.h"
#include "geometry/outline/drawing.h"
#include "geometry/outline/tps_file.h"
#include "geometry/picture/label_choice.h"
#include "geometry/picture/picture_shape.h"
#include "geometry/picture/read_mask.h"
#include "geometry/polydata/polydata.h"
#include "geometry/repair/make_shape.h"
#include "geometry/repair/repair_steps.h"
#include "geometry/scene/brain_surface.h"
#include "geometry/scene/scene_shape.h"
#include "tests/fuzz/edited_shape.h"
#include "tests/fuzz/memory_file.h"
#include "tests/fuzz/target.h"

#include <cmath>
#include <set>
#include <utility>

namespace shellmatch::fuzz {

namespace {

// What every reader of a shape promises (geometry/mesh_text/read_mesh_formats.h).
template <int Dim>
void check_original(const OriginalShape<Dim>& shape) {
  for (const Vec<Dim>& x : shape.vertices) demand(x.allFinite(), "coordinates are finite");
  for (const auto& polygon : shape.polygons)
    for (const Index v : polygon)
      demand(v >= 0 && static_cast<std::size_t>(v) < shape.vertices.size(), "polygons have vertices");
  for (const VertexAttribute& a : shape.attributes)
    demand((a.type == "text" ? a.texts.size() : a.values.size()) == shape.vertices.size(),
           "an attribute has a value for each vertex");
}

void check_image(const Picture& picture) {
  const GreyImage& image = picture.brightness;
  demand(image.values.size() == static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height),
         "an image is full");
  demand(picture.values.size() == image.values.size(), "a picture has a value for each pixel");
  std::vector<std::string> notes;
  if (image.values.size() >= 100000) return;
  for (const std::string_view text : {"1", "1,2", ">100"}) try {
      const GreyImage chosen = shape_of_picture(picture, parse_choice(text, "input", "mask.png"), "input", notes);
      demand(chosen.values.size() == image.values.size(), "a choice is full");
    } catch (const InputError&) {  // of no pixel, or of all
    }
  check_original(mask_rings(shape_of_picture(picture, {}, "input", notes), "input", notes));
}

// Whole, and one part of it, if its areas have names.
void check_drawing(const Drawing& drawing, const std::string& part = "") {
  check_original(outline_of_drawing(drawing, "input", part).shape);
  for (const DrawnArea& area : drawing.areas)
    if (!area.names.empty()) return check_original(outline_of_drawing(drawing, "input", area.names.back()).shape);
}

// What a mended shape is (geometry/repair/repair.h): closed, each edge run through once in each direction.
void check_mended(const Surface<3>& surface) {
  std::set<std::pair<Index, Index>> edges;
  for (const Vec<3>& x : surface.vertices) demand(x.allFinite(), "mended coordinates are finite");
  for (const auto& facet : surface.facets)
    for (std::size_t k = 0; k < 3; ++k) {
      demand(facet[k] >= 0 && static_cast<std::size_t>(facet[k]) < surface.vertices.size(), "facets have vertices");
      demand(facet[k] != facet[(k + 1) % 3], "facets have three corners");
      demand(edges.emplace(facet[k], facet[(k + 1) % 3]).second, "an edge runs once in a direction");
    }
  for (const auto& [a, b] : edges) demand(edges.contains({b, a}), "every edge has two facets");
  demand(!edges.empty() && std::isfinite(enclosed_measure(surface)), "there is a surface");
}

void check_mended(const Surface<2>& surface) {
  std::vector<int> n_in(surface.vertices.size(), 0), n_out = n_in;
  for (const auto& [a, b] : surface.facets)
    ++n_out.at(static_cast<std::size_t>(a)), ++n_in.at(static_cast<std::size_t>(b));
  for (std::size_t v = 0; v < n_in.size(); ++v) demand(n_in[v] == 1 && n_out[v] == 1, "an outline is made of rings");
  // Rings may touch at a point.
  demand(crossing_segments(surface, Contact::of_inner_points, 1).empty(), "an outline does not cross itself");
  // Up to rounding, which is that of the whole where coordinates differ by many orders of magnitude.
  const double diagonal = bounding_box(surface.vertices).diagonal();
  demand(enclosed_measure(surface) > -1e-9 * diagonal * diagonal, "an outline encloses an area");
}

template <int Dim>
void mend(OriginalShape<Dim> original) {
  const Shape<Dim> shape = make_shape(std::move(original), "input");
  check_mended(shape.surface);
}

}  // namespace

void read_obj_bytes(std::string_view bytes) {
  space_of_mesh(bytes);
  check_original(read_obj("input", bytes).shape);
}
void read_off_bytes(std::string_view bytes) { check_original(read_off("input", bytes).shape); }
void read_ply_bytes(std::string_view bytes) { check_original(read_ply("input", bytes).shape); }
void read_stl_bytes(std::string_view bytes) { check_original(read_stl("input", bytes).shape); }
void read_vtk_bytes(std::string_view bytes) {
  std::vector<std::string> notes;
  check_original(read_legacy_vtk("input", bytes, notes));
}
void read_vtp_bytes(std::string_view bytes) {
  std::vector<std::string> notes;
  check_original(read_vtp("input", bytes, notes));
}
void read_gifti_bytes(std::string_view bytes) { check_original(read_gifti("input", bytes).shape); }
void read_freesurfer_bytes(std::string_view bytes) { check_original(read_freesurfer("input", bytes).shape); }
void read_gltf_bytes(std::string_view bytes) { check_original(read_gltf("input", bytes).shape); }
void read_collada_bytes(std::string_view bytes) { check_original(read_collada("input", bytes).shape); }
void read_three_mf_bytes(std::string_view bytes) { check_original(read_three_mf("input", bytes).shape); }
void read_points_of_plane(std::string_view bytes) { check_original(read_points<2>("input", bytes, true)); }
void read_points_of_space(std::string_view bytes) { check_original(read_points<3>("input", bytes, false)); }
// The first part chooses, where there are two; a set of ROIs is told from one by its first bytes.
void read_tps_bytes(std::string_view bytes) {
  const std::size_t end = bytes.find(separator);
  const std::string part(end == bytes.npos ? std::string_view() : bytes.substr(0, end));
  const std::string_view text = end == bytes.npos ? bytes : bytes.substr(end + 1);
  std::string again;
  for (const TpsSpecimen& specimen : parse_tps("input", text)) {
    std::vector<double> coordinates;
    for (const auto& x : specimen.landmarks)
      for (int k = 0; k < specimen.dimension; ++k) coordinates.push_back(x ? (*x)[k] : std::nan(""));
    const std::size_t begin = again.size();
    append_tps_specimen(again, specimen.id.value_or(""), coordinates, static_cast<std::size_t>(specimen.dimension),
                        specimen.space);
    demand(parse_tps("again", std::string_view(again).substr(begin)).front().landmarks == specimen.landmarks,
           "landmarks are read back");
    if (specimen.landmarks.empty()) continue;
    if (specimen.dimension == 2) scaled_landmarks<2>(specimen, "input");
    else scaled_landmarks<3>(specimen, "input");
  }
  check_drawing(read_tps_outline("input", text, part), part);
}
void read_roi_bytes(std::string_view bytes) {
  check_drawing(bytes.starts_with("Iout") ? read_roi("input.roi", bytes) : read_roi_set("input", bytes));
}
void read_geojson_bytes(std::string_view bytes) { check_drawing(read_geojson("input", bytes)); }
void read_svg_bytes(std::string_view bytes) { check_drawing(read_svg("input", bytes)); }
void read_tiff_bytes(std::string_view bytes) { check_image(read_tiff("input", bytes)); }
void read_jpeg_bytes(std::string_view bytes) { check_image(read_jpeg("input", bytes)); }
void read_bmp_bytes(std::string_view bytes) { check_image(read_bmp("input", bytes)); }
void read_png_bytes(std::string_view bytes) { check_image(read_png("input", bytes)); }
void read_pgm_bytes(std::string_view bytes) { check_image(read_pgm("input", bytes)); }
void mend_edited_mesh(std::string_view bytes) { mend(edited_mesh(bytes)); }
void close_edited_mesh(std::string_view bytes) {
  const Shape<3> shape = make_shape(edited_mesh(bytes), "input", {}, Closing::automatic);
  check_mended(shape.surface);
  demand(shape.invented_share >= 0 && shape.invented_share <= 1 + 1e-9, "a share is one");
  demand(shape.evidence.is_complete() == (shape.invented_share == 0), "what was made up is there");
  for (const Surface<3>* part : {&shape.evidence.observed, &shape.evidence.unobserved})
    for (const Vec<3>& x : part->vertices) demand(x.allFinite(), "coordinates of parts are finite");
}
void mend_edited_outline(std::string_view bytes) { mend(edited_outline(bytes)); }

}  // namespace shellmatch::fuzz
