#include "geometry/scene/zip_file.h"

#include "base/error.h"
#include "base/printable.h"
#include "geometry/scene/inflate_stream.h"

#include <algorithm>
#include <cstdint>

namespace shellmatch {

namespace {

// A number of n bytes, the least first. \pre they are there
std::size_t number(std::string_view bytes, std::size_t at, std::size_t n) {
  std::size_t value = 0;
  for (std::size_t k = n; k-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[at + k]);
  return value;
}

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return result;
}

constexpr std::string_view end_mark("PK\5\6", 4), central_mark("PK\1\2", 4), local_mark("PK\3\4", 4);
constexpr std::size_t end_size = 22, central_size = 46, local_size = 30;

}  // namespace

ZipFile::ZipFile(const std::string& path, std::string_view bytes) : path_(path), bytes_(bytes) {
  const std::size_t end = bytes.rfind(end_mark);
  if (end == bytes.npos || bytes.size() - end < end_size)
    throw_input_error("{}: no ZIP archive, or cut off: its directory is missing at the end", path);
  const std::size_t n = number(bytes, end + 10, 2);
  std::size_t at = number(bytes, end + 16, 4);
  for (std::size_t i = 0; i < n; ++i) {
    if (at > end || end - at < central_size || bytes.substr(at, 4) != central_mark)
      throw_input_error("{}: the directory of the archive is damaged", path);
    const std::size_t name_size = number(bytes, at + 28, 2),
                      rest = number(bytes, at + 30, 2) + number(bytes, at + 32, 2);
    if (end - at - central_size < name_size + rest)
      throw_input_error("{}: the directory of the archive is damaged", path);
    const std::string_view name = bytes.substr(at + central_size, name_size);
    const auto [entry, is_new] = entries_.emplace(
        lower(name), Entry{number(bytes, at + 42, 4), number(bytes, at + 20, 4), number(bytes, at + 24, 4),
                           number(bytes, at + 10, 2), (number(bytes, at + 8, 2) & 1) != 0});
    if (is_new) names_.emplace_back(name);
    at += central_size + name_size + rest;
  }
}

std::optional<std::string> ZipFile::part(std::string_view name) const {
  const auto found = entries_.find(lower(name));
  if (found == entries_.end()) return {};
  const Entry& entry = found->second;
  const auto damaged = [&](std::string_view why) {
    throw_input_error("{}: its part '{}' {}", path_, printable(name, 60), why);
  };
  if (entry.is_encrypted) damaged("is encrypted; save the file without a password");
  if (entry.size == 0xffffffff || entry.packed == 0xffffffff) damaged("is larger than 4 GB; save less in it");
  if (entry.offset > bytes_.size() || bytes_.size() - entry.offset < local_size ||
      bytes_.substr(entry.offset, 4) != local_mark)
    damaged("is missing; the file is damaged");
  const std::size_t begin =
      entry.offset + local_size + number(bytes_, entry.offset + 26, 2) + number(bytes_, entry.offset + 28, 2);
  if (begin > bytes_.size() || bytes_.size() - begin < entry.packed) damaged("is cut off");
  const std::string_view packed = bytes_.substr(begin, entry.packed);
  if (entry.method == 0) return std::string(packed);
  if (entry.method != 8) damaged("is packed in a way that is not supported; save the file again");
  std::optional<std::string> inflated = inflate_stream(packed, StreamForm::raw, entry.size);
  if (!inflated) damaged("cannot be unpacked; the file is damaged");
  return inflated;
}

}  // namespace shellmatch
