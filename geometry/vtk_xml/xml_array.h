#pragma once
/// \file
/// The values of an array in VTK's XML files: as text, as base64 or raw, compressed by zlib or not.

#include "geometry/bytes/value_type.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace shellmatch {

/// What the first tag of a file says about its arrays.
struct XmlEncoding {
  bool is_big_endian = false;
  std::size_t header_bytes = 4;  ///< of each number before the values, 4 or 8
  bool is_compressed = false;
  bool is_appended_base64 = false;
};

enum class XmlFormat { ascii, binary, appended };

/// An array where it stands in the file.
struct XmlArray {
  std::string name;
  ValueType type = ValueType::float64;
  XmlFormat format = XmlFormat::ascii;
  std::size_t n_components = 1;
  std::string_view content;  ///< its text, or what is appended from its offset on to the next one's
};

/// The values. \param n how many there must be \throws InputError that names the file and the array
std::vector<double> xml_values(const std::string& path, const XmlArray& array, const XmlEncoding& encoding,
                               std::size_t n);

/// The bytes of an array whose length nobody has said; nothing where they are more than `most`. \throws as xml_values
std::string xml_bytes(const std::string& path, const XmlArray& array, const XmlEncoding& encoding, std::size_t most);

}  // namespace shellmatch
