#pragma once
/// \file
/// The header of a PLY file: its elements, their numbers and properties.

#include "geometry/bytes/value_type.h"
#include "geometry/mesh_text/read_text.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace shellmatch {

enum class PlyForm { text, little_endian, big_endian };
struct PlyProperty {
  std::string name;
  ValueType type = ValueType::float32;
  bool is_list = false;
  ValueType count_type = ValueType::uint8;  ///< of a list's length
};

struct PlyElement {
  std::string name;
  std::size_t n_items = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyForm form = PlyForm::text;
  std::vector<PlyElement> elements;
  std::vector<std::string> comments;  ///< lines 'comment' and 'obj_info', but for that which names the frame
};

/// Reads up to "end_header". \throws InputError naming the line if it is not a valid header, or if the file
/// is too short for the declared elements.
PlyHeader read_ply_header(LineReader& lines);

/// The type with this name, in the old or the new spelling ("uchar", "uint8"); nothing for other names.
std::optional<ValueType> ply_type(std::string_view name);
/// "8 vertex, 12 face".
std::string describe_counts(const PlyHeader& header);

}  // namespace shellmatch
