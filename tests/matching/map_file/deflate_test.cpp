// What deflate() compresses, zlib inflates.
#include "matching/map_file/deflate.h"
#include "geometry/bytes/inflate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>
#include <string_view>
#include <vector>

namespace shellmatch {
namespace {

std::size_t compressed_size(const std::vector<unsigned char>& data) {
  std::vector<unsigned char> stream(deflate_bound(data.size()));
  const std::size_t n = deflate(data, stream);
  EXPECT_GT(n, 0u);
  EXPECT_LE(n, stream.size());
  std::vector<char> back(data.size() + 1);
  const std::string_view view(reinterpret_cast<const char*>(stream.data()), n);
  EXPECT_TRUE(inflate_exactly(view, back.data(), data.size()));
  EXPECT_EQ(std::memcmp(back.data(), data.data(), data.size()), 0);
  EXPECT_FALSE(inflate_exactly(view, back.data(), data.size() + 1));
  return n;
}

TEST(Deflate, ZlibInflatesItsStreams) {
  std::vector<double> smooth(5000);
  for (std::size_t i = 0; i < smooth.size(); ++i) smooth[i] = std::floor(100 * std::sin(1e-3 * static_cast<double>(i)));
  std::vector<unsigned char> data(smooth.size() * sizeof(double));
  std::memcpy(data.data(), smooth.data(), data.size());
  EXPECT_LT(compressed_size(data), data.size() / 10);
}

TEST(Deflate, NoiseFitsTheBound) {
  std::mt19937 random(1);
  for (const std::size_t n : {1u, 100u, 70000u}) {
    std::vector<unsigned char> noise(n);
    for (unsigned char& c : noise) c = static_cast<unsigned char>(random());
    EXPECT_GE(compressed_size(noise), n);
  }
}

}  // namespace
}  // namespace shellmatch
