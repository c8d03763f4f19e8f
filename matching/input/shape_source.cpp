#include "matching/input/shape_source.h"

#include "geometry/repair/make_shape.h"
#include "matching/experiment/generated_source.h"

#include <utility>

namespace shellmatch {

AnyShape open_shape(const std::string& source, Closing closing) {
  if (!is_generated_source(source)) return read_shape(source, closing);
  return std::visit([&](auto original) -> AnyShape { return make_shape(std::move(original), source); },
                    generated_original(source));
}

}  // namespace shellmatch
