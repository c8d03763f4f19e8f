// What is packed can be read back as the header says, to the accuracy that it promises.

#include "matching/report/packed_arrays.h"

#include "geometry/bytes/inflate.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

namespace shellmatch {
namespace {

std::string unpacked_bytes(const PackedArrays& arrays) {
  const PackedArray& last = arrays.arrays().back();
  std::string bytes(last.offset + last.n_bytes, '\0');
  EXPECT_TRUE(inflate_exactly(arrays.compressed(), bytes.data(), bytes.size()));
  return bytes;
}

// Value i of an array whose bytes of the same rank are together.
std::uint32_t value_at(const std::string& bytes, const PackedArray& a, std::size_t width, std::size_t i) {
  const std::size_t n = a.n_bytes / width;
  std::uint32_t value = 0;
  for (std::size_t plane = 0; plane < width; ++plane)
    value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[a.offset + plane * n + i])) << (8 * plane);
  return value;
}

TEST(PackedArrays, PointsAreKeptToHalfAStepOfTheirBox) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> in(-3, 5);
  std::vector<Vec<3>> points;
  for (int i = 0; i < 500; ++i) points.emplace_back(in(random), 0.1 * in(random), 7.0);
  PackedArrays arrays;
  arrays.add_bytes("before", std::vector<std::uint8_t>{1, 2, 3});
  arrays.add_points<3>("points", points);
  const std::string bytes = unpacked_bytes(arrays);
  const PackedArray& a = arrays.arrays()[1];
  EXPECT_EQ(a.offset, 3u);
  EXPECT_EQ(a.n_bytes, 2 * 3 * points.size());
  EXPECT_NEAR(a.step, 8.0 / 65535, 0.2 / 65535);
  for (std::size_t k = 0; k < 3; ++k) {
    std::uint16_t steps = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      steps = static_cast<std::uint16_t>(steps + value_at(bytes, a, 2, k * points.size() + i));
      EXPECT_NEAR(a.low[k] + a.step * steps, points[i][static_cast<Index>(k)], 0.5001 * a.step);
    }
  }
}

TEST(PackedArrays, TakesPointsThatAreNoneOrOneOrNotFinite) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  PackedArrays arrays;
  arrays.add_points<2>("none", {});
  arrays.add_points<2>("one", std::vector<Vec<2>>{{3, 4}});
  arrays.add_points<2>("some", std::vector<Vec<2>>{{nan, 0}, {1, 2}, {infinite, 2}, {2, 3}});
  arrays.add_points<2>("no finite", std::vector<Vec<2>>{{nan, nan}});
  const std::string bytes = unpacked_bytes(arrays);
  EXPECT_EQ(arrays.arrays()[0].n_entries, 0u);
  EXPECT_EQ(arrays.arrays()[1].low, (std::array<double, 3>{3, 4, 0}));
  EXPECT_EQ(arrays.arrays()[2].low, (std::array<double, 3>{1, 2, 0}));
  EXPECT_EQ(arrays.arrays()[2].step, 1.0 / 65535);
  for (const PackedArray& a : arrays.arrays()) EXPECT_TRUE(std::isfinite(a.low[0]) && a.step > 0) << a.name;
}

TEST(PackedArrays, IndicesAreKeptAndNumbersRounded) {
  const std::vector<Index> indices = {5, 0, 2147483646, 7, 7, 1};
  constexpr double infinite = std::numeric_limits<double>::infinity();
  std::vector<double> numbers = {
      0, -1, 1e-30, 3.14159265, -2.7e20, infinite, std::numeric_limits<double>::quiet_NaN(), 3.4e38};
  for (int i = 1; i < 300; ++i) numbers.push_back(std::exp(0.37 * i - 50));
  PackedArrays arrays;
  arrays.add_indices("indices", 3, indices);
  arrays.add_numbers("numbers", numbers);
  const std::string bytes = unpacked_bytes(arrays);
  const PackedArray &of_indices = arrays.arrays()[0], &of_numbers = arrays.arrays()[1];
  EXPECT_EQ(of_indices.n_entries, 2u);
  std::int64_t index = 0;
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const std::int64_t code = value_at(bytes, of_indices, 4, i);
    index += code & 1 ? -(code + 1) / 2 : code / 2;
    EXPECT_EQ(index, indices[i]);
  }
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto kept = static_cast<double>(std::bit_cast<float>(value_at(bytes, of_numbers, 4, i)));
    if (std::isfinite(numbers[i])) EXPECT_NEAR(kept, numbers[i], std::abs(numbers[i]) / 8192);
    else if (std::isnan(numbers[i])) EXPECT_TRUE(std::isnan(kept));
    else EXPECT_EQ(kept, numbers[i]);
  }
}

// The published test vectors, and a byte that is no ASCII.
TEST(PackedArrays, Base64IsThatOfRfc4648) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xff\xef\xbe"), "/+++");
}

}  // namespace
}  // namespace shellmatch
