#include "geometry/repair/make_shape.h"

#include "geometry/repair/repair.h"

#include <utility>

namespace shellmatch {

template <int Dim>
Shape<Dim> make_shape(OriginalShape<Dim> original, std::string source, std::vector<std::string> notes) {
  Shape<Dim> shape{std::move(source), std::move(original), {}, std::move(notes)};
  if constexpr (Dim == 2) shape.surface = mend_outline(shape.original, shape.source, shape.notes);
  else shape.surface = mend_surface(shape.original, shape.source, shape.notes);
  return shape;
}

template Shape<2> make_shape<2>(OriginalShape<2>, std::string, std::vector<std::string>);
template Shape<3> make_shape<3>(OriginalShape<3>, std::string, std::vector<std::string>);

}  // namespace shellmatch
