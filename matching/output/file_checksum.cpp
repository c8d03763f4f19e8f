#include "matching/output/file_checksum.h"

#include "base/error.h"
#include "matching/output/checksum.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>

namespace shellmatch {

namespace {

std::string seal_text(std::uint64_t sum) {
  return fmt::format("\n<!-- shellmatch checksum {} -->\n", checksum_text(sum));
}

}  // namespace

void seal_file(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  const auto sum = error ? std::nullopt : stream_checksum(in, size);
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
  const auto sum = stream_checksum(in, size - seal);
  std::string found(seal, '\0');
  return sum && in.read(found.data(), static_cast<std::streamsize>(seal)) && found == seal_text(*sum);
}

}  // namespace shellmatch
