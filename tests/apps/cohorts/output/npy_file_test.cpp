// Arrays in NumPy's format.

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "apps/cohorts/output/npy_file.h"

namespace shellmatch {
namespace {

std::string bytes_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

TEST(NpyFile, HasTheHeadThatTheFormatAsksFor) {
  const std::string path = testing::TempDir() + "/shellmatch_npy_test.npy";
  const std::vector<double> values{1, -2, 3.5, 1e300, 5, 6};
  write_npy(path, {3, 2}, values);
  const std::string bytes = bytes_of(path);
  ASSERT_EQ(bytes.size() % 64, sizeof(double) * values.size() % 64);
  EXPECT_EQ(bytes.substr(0, 8), std::string("\x93NUMPY\x01\x00", 8));
  const std::size_t n = static_cast<unsigned char>(bytes[8]) + 256u * static_cast<unsigned char>(bytes[9]);
  EXPECT_EQ((10 + n) % 64, 0u);
  const std::string head = bytes.substr(10, n);
  EXPECT_EQ(head.back(), '\n');
  EXPECT_TRUE(head.starts_with("{'descr': '<f8', 'fortran_order': False, 'shape': (3, 2, ), }")) << head;
  std::vector<double> read(values.size());
  ASSERT_EQ(bytes.size(), 10 + n + sizeof(double) * values.size());
  std::memcpy(read.data(), bytes.data() + 10 + n, sizeof(double) * read.size());
  EXPECT_EQ(read, values);
  std::filesystem::remove(path);
}

TEST(NpyFile, IndicesAreIntegersOfFourBytes) {
  const std::string path = testing::TempDir() + "/shellmatch_npy_faces.npy";
  write_npy(path, {1, 3}, std::vector<std::int32_t>{7, 8, 9});
  const std::string bytes = bytes_of(path);
  EXPECT_NE(bytes.find("'<i4'"), std::string::npos);
  EXPECT_EQ(bytes.substr(bytes.size() - 12), std::string("\x07\0\0\0\x08\0\0\0\x09\0\0\0", 12));
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace shellmatch
