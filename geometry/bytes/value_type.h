#pragma once
/// \file
/// Types of the values in files, values out of bytes, and bytes out of values and text.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace shellmatch {

enum class ValueType { int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64, bit };

/// By its name in legacy files, "unsigned_char", or in XML files, "UInt8"; nothing for other names.
std::optional<ValueType> legacy_type(std::string_view name);
std::optional<ValueType> xml_type(std::string_view name);
/// The name that columns of a shape have for it (VertexAttribute::type): PLY's, and "int64", "uint64".
std::string_view column_type(ValueType type);

/// Bytes that n values take; bits are packed.
std::size_t bytes_of(ValueType type, std::size_t n = 1);

/// A value out of the bytes at `at`, in either order. \pre the type is not bit, and the bytes are there
double value_of(const char* at, ValueType type, bool is_big_endian);

/// n values out of bytes of either order. \pre there are bytes_of(type, n) bytes
std::vector<double> values_of(std::string_view bytes, ValueType type, std::size_t n, bool is_big_endian);

/// Appends the bytes of a value, the lowest first. Integers are rounded and clamped to the range of the type, NaN
/// becomes 0. \pre the type is not bit
void append_value(std::string& bytes, ValueType type, double value);

/// Bytes out of base64 (RFC 4648), blanks left out, up to the first character that is none of its own: what follows is
/// another's. Texts may follow one another, so that the fill '=' stands within. Nothing where the fill is too long.
std::optional<std::string> decode_base64(std::string_view text);

}  // namespace shellmatch
