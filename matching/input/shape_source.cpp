#include "matching/input/shape_source.h"

#include "geometry/io/input_file.h"
#include "geometry/repair/make_shape.h"
#include "geometry/volume/volume_header.h"
#include "geometry/volume/volume_name.h"
#include "geometry/label/volume_shape.h"
#include "matching/experiment/generated_source.h"

#include <utility>

namespace shellmatch {

AnyShape open_shape(const std::string& source, Closing closing, Space space) {
  if (const auto volume = parse_volume_name(source)) return volume_shape(*volume, source, space);
  if (!is_generated_source(source)) return read_shape(source, closing);
  return std::visit([&](auto original) -> AnyShape { return make_shape(std::move(original), source); },
                    generated_original(source));
}

bool ShapeInput::is_volume() const {
  return std::holds_alternative<VolumePart>(contents) || (contents.index() == 0 && parse_volume_name(name));
}

AnyShape open_shape(ShapeInput input, Closing closing, Space space) {
  if (auto* outline = std::get_if<OriginalShape<2>>(&input.contents))
    return make_shape(std::move(*outline), input.name);
  if (auto* mesh = std::get_if<OriginalShape<3>>(&input.contents))
    return make_shape(std::move(*mesh), input.name, {}, closing);
  if (auto* part = std::get_if<VolumePart>(&input.contents)) return volume_shape(std::move(*part), input.name, space);
  return open_shape(input.name, closing, space);
}

std::vector<std::string> files_of_shape(const std::string& source) {
  if (!parse_volume_name(source)) return {split_part(source).file};
  const std::string file = file_of(source);
  const std::string values = read_volume_header(file).file;
  return values == file ? std::vector{file} : std::vector{file, values};
}

}  // namespace shellmatch
