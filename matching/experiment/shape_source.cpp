#include "matching/experiment/shape_source.h"

#include "geometry/repair/repair.h"
#include "matching/experiment/generated_source.h"

namespace shellmatch {

namespace {

template <int Dim>
Shape<Dim> mended(OriginalShape<Dim> original, const std::string& source) {
  Shape<Dim> shape;
  shape.source = source;
  shape.original = std::move(original);
  if constexpr (Dim == 2) shape.surface = mend_outline(shape.original, source, shape.notes);
  else shape.surface = mend_surface(shape.original, source, shape.notes);
  return shape;
}

}  // namespace

AnyShape open_shape(const std::string& source) {
  if (!is_generated_source(source)) return read_shape(source);
  return std::visit([&](auto original) -> AnyShape { return mended(std::move(original), source); },
                    generated_original(source));
}

}  // namespace shellmatch
