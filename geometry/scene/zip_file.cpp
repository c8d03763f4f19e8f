#include "geometry/scene/zip_file.h"

#include "base/error.h"
#include "base/printable.h"
#include "geometry/bytes/inflate.h"

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

constexpr std::string_view end_mark("PK\5\6", 4), central_mark("PK\1\2", 4), local_mark("PK\3\4", 4),
    locator_mark("PK\6\7", 4), wide_end_mark("PK\6\6", 4);
constexpr std::size_t end_size = 22, central_size = 46, local_size = 30, locator_size = 20, wide_end_size = 56;
constexpr std::size_t elsewhere = 0xffffffff;  // a number of four bytes that is in its place of ZIP64

struct Directory {
  std::size_t begin, n_entries;
};

// Archives may have their numbers in ZIP64's records however small they are; lib3mf writes no others.
std::optional<Directory> directory_of(std::string_view bytes, std::size_t end) {
  const Directory narrow{number(bytes, end + 16, 4), number(bytes, end + 10, 2)};
  if (narrow.begin != elsewhere && narrow.n_entries != 0xffff) return narrow;
  if (end < locator_size || bytes.substr(end - locator_size, 4) != locator_mark) return narrow;
  const std::size_t at = number(bytes, end - locator_size + 8, 8);
  if (at > end || end - at < wide_end_size || bytes.substr(at, 4) != wide_end_mark) return {};
  return Directory{number(bytes, at + 48, 8), number(bytes, at + 32, 8)};
}

// The next number of ZIP64's extra field, which has those that are elsewhere, in their order. \param field what is left
bool take_wide(std::string_view& field, std::size_t& value) {
  if (value != elsewhere) return true;
  if (field.size() < 8) return false;
  value = number(field, 0, 8);
  field.remove_prefix(8);
  return true;
}

// The contents of ZIP64's field among the extra ones.
std::string_view wide_field(std::string_view extra) {
  while (extra.size() >= 4) {
    const std::size_t size = number(extra, 2, 2);
    if (extra.size() - 4 < size) break;
    if (number(extra, 0, 2) == 1) return extra.substr(4, size);
    extra.remove_prefix(4 + size);
  }
  return {};
}

}  // namespace

ZipFile::ZipFile(const std::string& path, std::string_view bytes) : path_(path), bytes_(bytes) {
  const std::size_t end = bytes.rfind(end_mark);
  if (end == bytes.npos || bytes.size() - end < end_size)
    throw_input_error("{}: no ZIP archive, or cut off: its directory is missing at the end", path);
  const auto damaged = [&] { throw_input_error("{}: the directory of the archive is damaged", path); };
  const std::optional<Directory> directory = directory_of(bytes, end);
  if (!directory) damaged();
  std::size_t at = directory->begin;
  for (std::size_t i = 0; i < directory->n_entries; ++i) {
    if (at > end || end - at < central_size || bytes.substr(at, 4) != central_mark) damaged();
    const std::size_t name_size = number(bytes, at + 28, 2), extra_size = number(bytes, at + 30, 2),
                      rest = extra_size + number(bytes, at + 32, 2);
    if (end - at - central_size < name_size + rest) damaged();
    const std::string_view name = bytes.substr(at + central_size, name_size);
    Entry entry{number(bytes, at + 42, 4), number(bytes, at + 20, 4), number(bytes, at + 24, 4),
                number(bytes, at + 10, 2), (number(bytes, at + 8, 2) & 1) != 0};
    std::string_view wide = wide_field(bytes.substr(at + central_size + name_size, extra_size));
    if (!take_wide(wide, entry.size) || !take_wide(wide, entry.packed) || !take_wide(wide, entry.offset)) damaged();
    if (entries_.emplace(lower(name), entry).second) names_.emplace_back(name);
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
  if (entry.size >= elsewhere || entry.packed >= elsewhere) damaged("is larger than 4 GB; save less in it");
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
