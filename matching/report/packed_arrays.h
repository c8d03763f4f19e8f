#pragma once
/// \file
/// Arrays of numbers packed for a page: rounded to what can be seen, ordered so that they compress, compressed, and as
/// text. matching/page/data/arrays.js reads them.

#include "base/types.h"

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace shellmatch {

/// How the bytes of an array are to be read. All values of several bytes are little-endian; the bytes of the same rank
/// are together, the lowest first, and so are, before that, the values of the same component.
enum class PackedKind {
  points,   ///< 16-bit differences from the value before; times `step`, plus `low` of the component
  indices,  ///< 32-bit differences from the index before, zigzag-coded: 2d, or -2d - 1 for d < 0
  numbers,  ///< 32-bit floating point, rounded to `significant_bits`
  bytes,    ///< as they are
};

struct PackedArray {
  std::string name;
  PackedKind kind = PackedKind::bytes;
  int n_components = 1;
  std::size_t n_entries = 0;            ///< of n_components values each
  std::size_t offset = 0, n_bytes = 0;  ///< in the uncompressed bytes of all arrays
  std::array<double, 3> low{};
  double step = 0;
};

/// Collects arrays.
class PackedArrays {
 public:
  static constexpr int significant_bits = 13;  ///< of numbers: to 1/16000
  static constexpr double n_steps = 65535;     ///< of points, along the longest side of their box

  /// Points that are not finite are put where the box begins.
  template <int Dim>
  void add_points(std::string name, std::span<const Vec<Dim>> points);
  /// \param n_components indices of one entry, as 3 for triangles
  void add_indices(std::string name, int n_components, std::span<const Index> indices);
  /// Values that are not finite stay so.
  void add_numbers(std::string name, std::span<const double> values);
  void add_bytes(std::string name, std::span<const std::uint8_t> bytes);

  const std::vector<PackedArray>& arrays() const { return arrays_; }
  /// All arrays, compressed (zlib's form).
  std::string compressed() const;

 private:
  PackedArray& begin(std::string name, PackedKind kind, int n_components, std::size_t n_entries);
  template <class Value>
  void append_planes(const std::vector<Value>& values);

  std::vector<PackedArray> arrays_;
  std::string bytes_;
};

/// The bytes in base64 (RFC 4648), without line breaks.
std::string base64(std::string_view bytes);

}  // namespace shellmatch
