#include "geometry/repair/make_shape.h"

#include "base/error.h"

#include <string_view>
#include <utility>

namespace shellmatch {

namespace {

// Areas, volumes and their squares are formed of coordinates: within these limits they neither overflow nor vanish.
template <int Dim>
void check_size(const std::vector<Vec<Dim>>& vertices, std::string_view what, const std::string& source) {
  constexpr double least = 1e-50, most = 1e50;
  if (vertices.empty()) return;
  const Box<Dim> box = bounding_box(vertices);
  const double largest = box.min.cwiseAbs().cwiseMax(box.max.cwiseAbs()).maxCoeff(),
               side = (box.max - box.min).maxCoeff();
  if (largest > most)
    throw_input_error("{}: a coordinate is {:.3g}, and coordinates up to {:g} can be used; scale the shape", source,
                      largest, most);
  if (side > 0 && side < least)
    throw_input_error("{}: {} has a size of {:.3g}, and sizes from {:g} on can be used; scale the shape", source, what,
                      side, least);
}

}  // namespace

template <int Dim>
Shape<Dim> make_shape(OriginalShape<Dim> original, std::string source, std::vector<std::string> notes,
                      Closing closing) {
  check_size(original.vertices, "the shape", source);
  Shape<Dim> shape{std::move(source), std::move(original), {}, std::move(notes)};
  if constexpr (Dim == 2) shape.surface = mend_outline(shape.original, shape.source, shape.notes);
  else {
    MendedSurface mended = mend_surface(shape.original, shape.source, shape.notes, closing);
    shape.surface = std::move(mended.surface);
    shape.evidence = std::move(mended.evidence);
    shape.invented_share = mended.invented_share;
    shape.crossing = std::move(mended.crossing);
  }
  // What is left may be much smaller than the original: a spike without width has been removed.
  check_size(shape.surface.vertices, "the mended shape", shape.source);
  return shape;
}

SHELLMATCH_2D_3D(make_shape);

}  // namespace shellmatch
