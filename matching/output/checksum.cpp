#include "matching/output/checksum.h"

#include "base/error.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>

namespace shellmatch {

namespace {

constexpr std::string_view earlier_begin = "\n<!-- shellmatch checksum ", line_end = " -->\n";

std::string checksum_line(const std::string& sum) { return fmt::format("\n<!-- shellmatch xxh3 {}{}", sum, line_end); }

// The last n bytes of a file; nothing if it is shorter.
std::string end_of(std::ifstream& in, std::uintmax_t size, std::size_t n) {
  if (size < n) return "";
  std::string end(n, '\0');
  in.seekg(static_cast<std::streamoff>(size - n));
  in.read(end.data(), static_cast<std::streamsize>(n));
  return end;
}

}  // namespace

void append_checksum(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  const auto sum = error ? std::nullopt : stream_checksum(in, size);
  std::ofstream out(path, std::ios::binary | std::ios::app);
  if (sum) out << checksum_line(*sum);
  out.close();
  if (!sum || !out)
    cannot_be_written(0, fmt::format("{}: cannot be written; is the disk full or the folder read-only?", path));
}

FileChecksum verify_checksum(const std::string& path) {
  std::error_code error;
  // Opening a pipe would wait for its other end.
  if (std::filesystem::exists(path, error) && !std::filesystem::is_regular_file(path, error))
    throw_input_error("{}: is no file; expected one that can be read", path);
  std::ifstream in(path, std::ios::binary);
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (!in || error) throw_input_error("{}: cannot be read; does the file exist, and may you read it?", path);
  constexpr std::size_t n_digits = 16;
  const std::string earlier = end_of(in, size, earlier_begin.size() + n_digits + line_end.size());
  if (earlier.starts_with(earlier_begin) && earlier.ends_with(line_end)) return FileChecksum::earlier;
  const std::string found = end_of(in, size, checksum_line(std::string(n_digits, '0')).size());
  if (found.empty()) return FileChecksum::differs;
  in.seekg(0);
  const auto sum = stream_checksum(in, size - found.size());
  return sum && found == checksum_line(*sum) ? FileChecksum::matches : FileChecksum::differs;
}

}  // namespace shellmatch
