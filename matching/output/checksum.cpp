#include "matching/output/checksum.h"

#include "base/error.h"

#include <filesystem>
#include <fstream>
#include <vector>

namespace shellmatch {

std::uint64_t text_checksum(std::string_view text, std::uint64_t begin) {
  std::uint64_t sum = begin;
  for (const char c : text) sum = (sum ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  return sum;
}

std::optional<std::uint64_t> stream_checksum(std::istream& in, std::uintmax_t length) {
  std::uint64_t sum = text_checksum("");
  std::vector<char> block(1 << 20);
  while (length > 0) {
    const std::uintmax_t n = std::min<std::uintmax_t>(length, block.size());
    if (!in.read(block.data(), static_cast<std::streamsize>(n))) return std::nullopt;
    sum = text_checksum({block.data(), static_cast<std::size_t>(n)}, sum);
    length -= n;
  }
  return sum;
}

std::uint64_t file_checksum(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  const auto sum = in && !error ? stream_checksum(in, size) : std::nullopt;
  if (!sum) throw_input_error("{}: cannot be read; does the file exist, and may you read it?", path);
  return *sum;
}

std::string checksum_text(std::uint64_t sum) { return fmt::format("{:016x}", sum); }

}  // namespace shellmatch
