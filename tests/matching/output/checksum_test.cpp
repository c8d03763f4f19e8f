#include "matching/output/checksum.h"

#include "base/error.h"
#include "tests/matching/output/temporary_folder.h"

#include <gtest/gtest.h>

#include <random>

namespace shellmatch {
namespace {

using testing::contents_of;
using testing::message_of;
using testing::put;
using testing::TemporaryFolder;

std::string random_bytes(std::size_t n) {
  std::mt19937 random(3);
  std::string bytes(n, '\0');
  for (char& c : bytes) c = static_cast<char>(random());
  return bytes;
}

// xxHash's command line tool: `printf '' | xxhsum -H3`, `printf shellmatch | xxhsum -H3`.
TEST(ChecksumTest, IsXxh3) {
  EXPECT_EQ(text_checksum(""), "2d06800538d394c2");
  EXPECT_EQ(text_checksum("shellmatch"), "030969302ea45418");
}

TEST(ChecksumTest, PiecesAndFilesHaveThatOfTheWhole) {
  const TemporaryFolder tmp;
  const std::string bytes = random_bytes(3'000'001);  // more than is read at once
  const std::string whole = text_checksum(bytes);
  const std::string_view view = bytes;
  EXPECT_EQ(Checksum().add(view.substr(0, 5)).add("").add(view.substr(5)).text(), whole);
  put(tmp / "file", bytes);
  EXPECT_EQ(file_checksum(tmp / "file"), whole);
  EXPECT_NE(message_of<InputError>([&] { file_checksum(tmp / "nowhere"); }).find("nowhere"), std::string::npos);
}

TEST(ChecksumTest, OneBitChangesIt) {
  std::string bytes = random_bytes(1000);
  const std::string before = text_checksum(bytes);
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    bytes[bit / 8] ^= static_cast<char>(1 << bit % 8);
    ASSERT_NE(text_checksum(bytes), before) << bit;
    bytes[bit / 8] ^= static_cast<char>(1 << bit % 8);
  }
}

TEST(FileChecksumTest, MatchesDiffersOrIsOfAnEarlierForm) {
  const TemporaryFolder tmp;
  for (const std::size_t n : {0, 1, 10, 2'000'000}) {
    const std::string bytes = random_bytes(n);
    put(tmp / "file", bytes);
    EXPECT_EQ(verify_checksum(tmp / "file"), FileChecksum::differs) << "none yet";
    append_checksum(tmp / "file");
    EXPECT_EQ(verify_checksum(tmp / "file"), FileChecksum::matches);
    const std::string whole = contents_of(tmp / "file");
    EXPECT_TRUE(whole.starts_with(bytes));
    for (const std::size_t at : {std::size_t{0}, n / 2, n, n + 25, whole.size() - 1}) {
      std::string changed = whole;
      changed[at] ^= 4;
      put(tmp / "file", changed);
      EXPECT_EQ(verify_checksum(tmp / "file"), FileChecksum::differs) << at;
    }
    put(tmp / "file", bytes + "\n<!-- shellmatch checksum 00f3a1b2c3d4e5f6 -->\n");
    EXPECT_EQ(verify_checksum(tmp / "file"), FileChecksum::earlier);
  }
  EXPECT_THROW(verify_checksum(tmp / "nowhere"), InputError);
}

}  // namespace
}  // namespace shellmatch
