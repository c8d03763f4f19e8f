#include "geometry/bytes/value_type.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

namespace shellmatch {

namespace {

static_assert(std::endian::native == std::endian::little);

struct ValueTypeFacts {
  std::string_view legacy, xml, column;
  std::size_t size;
};
constexpr ValueTypeFacts value_types[] = {{"char", "Int8", "char", 1},
                                          {"unsigned_char", "UInt8", "uchar", 1},
                                          {"short", "Int16", "short", 2},
                                          {"unsigned_short", "UInt16", "ushort", 2},
                                          {"int", "Int32", "int", 4},
                                          {"unsigned_int", "UInt32", "uint", 4},
                                          {"vtktypeint64", "Int64", "int64", 8},
                                          {"vtktypeuint64", "UInt64", "uint64", 8},
                                          {"float", "Float32", "float", 4},
                                          {"double", "Float64", "double", 8},
                                          {"bit", "", "uchar", 0}};

const ValueTypeFacts& facts_of(ValueType type) { return value_types[static_cast<std::size_t>(type)]; }

std::optional<ValueType> type_named(std::string_view name, std::string_view ValueTypeFacts::*field) {
  const auto at = std::ranges::find(value_types, name, field);
  if (name.empty() || at == std::end(value_types)) return std::nullopt;
  return static_cast<ValueType>(at - std::begin(value_types));
}

// Calls `use` with a value of the C++ type.
template <class Use>
decltype(auto) with_type(ValueType type, const Use& use) {
  switch (type) {
    case ValueType::int8: return use(std::int8_t{});
    case ValueType::uint8: return use(std::uint8_t{});
    case ValueType::int16: return use(std::int16_t{});
    case ValueType::uint16: return use(std::uint16_t{});
    case ValueType::int32: return use(std::int32_t{});
    case ValueType::uint32: return use(std::uint32_t{});
    case ValueType::int64: return use(std::int64_t{});
    case ValueType::uint64: return use(std::uint64_t{});
    case ValueType::float32: return use(float{});
    default: return use(double{});
  }
}

template <class T>
double number_at(const char* at, bool is_big_endian) {
  std::array<char, sizeof(T)> raw;
  std::memcpy(raw.data(), at, sizeof(T));
  if (is_big_endian) std::ranges::reverse(raw);
  return static_cast<double>(std::bit_cast<T>(raw));
}

}  // namespace

std::optional<ValueType> legacy_type(std::string_view name) {
  // VTK writes the numbers of things as int, whatever their size in memory.
  if (name == "vtkIdType" || name == "vtkidtype") return ValueType::int32;
  if (name == "signed_char") return ValueType::int8;
  // Sizes of these differ between machines; files with them are of 64-bit systems.
  if (name == "long" || name == "long_long") return ValueType::int64;
  if (name == "unsigned_long" || name == "unsigned_long_long") return ValueType::uint64;
  return type_named(name, &ValueTypeFacts::legacy);
}

std::optional<ValueType> xml_type(std::string_view name) { return type_named(name, &ValueTypeFacts::xml); }
std::string_view column_type(ValueType type) { return facts_of(type).column; }

std::size_t bytes_of(ValueType type, std::size_t n) {
  return type == ValueType::bit ? (n + 7) / 8 : n * facts_of(type).size;
}

double value_of(const char* at, ValueType type, bool is_big_endian) {
  return with_type(type, [&]<class T>(T) { return number_at<T>(at, is_big_endian); });
}

std::vector<double> values_of(std::string_view bytes, ValueType type, std::size_t n, bool is_big_endian) {
  std::vector<double> values;
  values.reserve(n);
  if (type == ValueType::bit) {
    for (std::size_t i = 0; i < n; ++i) values.push_back((static_cast<unsigned char>(bytes[i / 8]) >> (7 - i % 8)) & 1);
    return values;
  }
  with_type(type, [&]<class T>(T) {
    for (std::size_t i = 0; i < n; ++i) values.push_back(number_at<T>(bytes.data() + i * sizeof(T), is_big_endian));
  });
  return values;
}

void append_value(std::string& bytes, ValueType type, double value) {
  with_type(type, [&]<class T>(T number) {
    if constexpr (std::is_integral_v<T>) {
      // The largest integers of 64 bits are no doubles.
      constexpr double exact = 9007199254740992;
      const double least = std::max<double>(std::numeric_limits<T>::min(), -exact),
                   most = std::min<double>(std::numeric_limits<T>::max(), exact);
      number = static_cast<T>(std::isnan(value) ? 0 : std::clamp(std::round(value), least, most));
    } else {
      number = static_cast<T>(value);
    }
    bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
  });
}

std::optional<std::string> decode_base64(std::string_view text) {
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3);
  std::uint32_t group = 0;
  int n_in_group = 0, n_fill = 0;
  for (const char c : text) {
    int digit = 0;
    if (c >= 'A' && c <= 'Z') digit = c - 'A';
    else if (c >= 'a' && c <= 'z') digit = c - 'a' + 26;
    else if (c >= '0' && c <= '9') digit = c - '0' + 52;
    else if (c == '+') digit = 62;
    else if (c == '/') digit = 63;
    else if (c == '=') ++n_fill;
    else if (c == ' ' || c == '\n' || c == '\r' || c == '\t') continue;
    else break;
    group = group << 6 | static_cast<std::uint32_t>(digit);
    if (++n_in_group < 4) continue;
    if (n_fill > 2) return std::nullopt;
    for (int k = 0; k < 3 - n_fill; ++k) bytes.push_back(static_cast<char>(group >> (16 - 8 * k) & 0xff));
    group = 0;
    n_in_group = n_fill = 0;
  }
  return bytes;
}

}  // namespace shellmatch
