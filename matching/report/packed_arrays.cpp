#include "matching/report/packed_arrays.h"

#include "geometry/surface/surface.h"
#include "geometry/volume/zlib_volume.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace shellmatch {

namespace {

// Rounds the mantissa, so that the low bits are zeros, which compress.
std::uint32_t rounded_bits(double value) {
  const auto number = static_cast<float>(value);
  if (!std::isfinite(number)) return std::bit_cast<std::uint32_t>(number);
  constexpr int dropped = 24 - PackedArrays::significant_bits;
  const std::uint32_t bits = std::bit_cast<std::uint32_t>(number),
                      rounded = (bits + (1u << (dropped - 1))) & ~((1u << dropped) - 1);
  return std::isfinite(std::bit_cast<float>(rounded)) ? rounded : bits;
}

}  // namespace

PackedArray& PackedArrays::begin(std::string name, PackedKind kind, int n_components, std::size_t n_entries) {
  arrays_.push_back({std::move(name), kind, n_components, n_entries, bytes_.size(), 0, {}, 0});
  return arrays_.back();
}

// The lowest bytes of all values, then the next ones.
template <class Value>
void PackedArrays::append_planes(const std::vector<Value>& values) {
  for (std::size_t plane = 0; plane < sizeof(Value); ++plane)
    for (const Value v : values) bytes_ += static_cast<char>(v >> (8 * plane) & 0xff);
  arrays_.back().n_bytes = bytes_.size() - arrays_.back().offset;
}

template <int Dim>
void PackedArrays::add_points(std::string name, std::span<const Vec<Dim>> points) {
  Box<Dim> box;
  for (const Vec<Dim>& x : points)
    if (x.allFinite()) box.add(x);
  if (!(box.max.array() >= box.min.array()).all()) box = {Vec<Dim>::Zero(), Vec<Dim>::Zero()};
  PackedArray& array = begin(std::move(name), PackedKind::points, Dim, points.size());
  const double side = (box.max - box.min).maxCoeff();
  array.step = side > 0 ? side / n_steps : 1;
  std::vector<std::uint16_t> differences;
  differences.reserve(Dim * points.size());
  for (int k = 0; k < Dim; ++k) {
    array.low[static_cast<std::size_t>(k)] = box.min[k];
    std::uint16_t last = 0;
    for (const Vec<Dim>& x : points) {
      const double steps = x.allFinite() ? (x[k] - box.min[k]) / array.step : 0;
      const auto value = static_cast<std::uint16_t>(std::lround(std::clamp(steps, 0.0, n_steps)));
      differences.push_back(static_cast<std::uint16_t>(value - last));
      last = value;
    }
  }
  append_planes(differences);
}

void PackedArrays::add_indices(std::string name, int n_components, std::span<const Index> indices) {
  begin(std::move(name), PackedKind::indices, n_components, indices.size() / static_cast<std::size_t>(n_components));
  std::vector<std::uint32_t> differences;
  differences.reserve(indices.size());
  std::int64_t last = 0;
  for (const Index i : indices) {
    const std::int64_t d = i - last;
    differences.push_back(static_cast<std::uint32_t>(d < 0 ? -2 * d - 1 : 2 * d));
    last = i;
  }
  append_planes(differences);
}

void PackedArrays::add_numbers(std::string name, std::span<const double> values) {
  begin(std::move(name), PackedKind::numbers, 1, values.size());
  std::vector<std::uint32_t> bits;
  bits.reserve(values.size());
  for (const double v : values) bits.push_back(rounded_bits(v));
  append_planes(bits);
}

void PackedArrays::add_bytes(std::string name, std::span<const std::uint8_t> bytes) {
  begin(std::move(name), PackedKind::bytes, 1, bytes.size());
  append_planes(std::vector<std::uint8_t>(bytes.begin(), bytes.end()));
}

std::string PackedArrays::compressed() const { return deflated(bytes_, Deflated::zlib); }

std::string base64(std::string_view bytes) {
  static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t n = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 3; ++k) word = word << 8 | (k < n ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) text += k <= n ? digits[word >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

template void PackedArrays::add_points<2>(std::string, std::span<const Vec<2>>);
template void PackedArrays::add_points<3>(std::string, std::span<const Vec<3>>);

}  // namespace shellmatch
