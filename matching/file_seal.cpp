#include "matching/file_seal.h"

#include "base/error.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <vector>

namespace shellmatch {

namespace {

// FNV-1a, 64 bits (Fowler, Noll, Vo): every step is invertible, so that one changed byte never goes unseen.
std::optional<std::uint64_t> checksum(std::ifstream& in, std::uintmax_t length) {
  std::uint64_t sum = 0xcbf29ce484222325u;
  std::vector<char> block(1 << 20);
  while (length > 0) {
    const std::uintmax_t n = std::min<std::uintmax_t>(length, block.size());
    if (!in.read(block.data(), static_cast<std::streamsize>(n))) return std::nullopt;
    for (std::uintmax_t i = 0; i < n; ++i)
      sum = (sum ^ static_cast<unsigned char>(block[i])) * 0x100000001b3u;
    length -= n;
  }
  return sum;
}

std::string seal_text(std::uint64_t sum) {
  return fmt::format("\n<!-- shellmatch checksum {:016x} -->\n", sum);
}

}  // namespace

void seal_file(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  const auto sum = error ? std::nullopt : checksum(in, size);
  std::ofstream out(path, std::ios::binary | std::ios::app);
  if (sum) out << seal_text(*sum);
  out.close();
  if (!sum || !out)
    throw_environment_error("{}: cannot be written; is the disk full or the folder read-only?", path);
}

bool is_sealed(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error), seal = seal_text(0).size();
  if (!in || error) throw_input_error("{}: cannot be read; does the file exist, and may you read it?", path);
  if (size < seal) return false;
  const auto sum = checksum(in, size - seal);
  std::string found(seal, '\0');
  return sum && in.read(found.data(), static_cast<std::streamsize>(seal)) && found == seal_text(*sum);
}

}  // namespace shellmatch
