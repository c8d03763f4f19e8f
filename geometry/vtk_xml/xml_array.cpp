#include "geometry/vtk_xml/xml_array.h"

#include "base/error.h"
#include "base/printable.h"
#include "base/stop.h"
#include "geometry/mesh_text/read_text.h"
#include "geometry/bytes/inflate.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

namespace shellmatch {

namespace {

class XmlValues {
 public:
  XmlValues(const std::string& path, const XmlArray& array, const XmlEncoding& encoding, std::size_t n)
      : path_(path), array_(array), encoding_(encoding), n_(n) {}

  std::vector<double> read() const {
    if (array_.format == XmlFormat::ascii) return text_values();
    const std::string decoded = is_base64() ? this->decoded() : std::string();
    const std::string_view bytes = is_base64() ? std::string_view(decoded) : array_.content;
    if (n_ > std::numeric_limits<std::size_t>::max() / 16) damaged("its size");
    const std::size_t n_bytes = bytes_of(array_.type, n_);
    if (encoding_.is_compressed) return values_of(expanded(bytes, n_bytes), array_.type, n_, encoding_.is_big_endian);
    const std::size_t n_there = word(bytes, 0);
    if (n_there != n_bytes) damaged(fmt::format("{} bytes where {} should be", n_there, n_bytes));
    if (bytes.size() - encoding_.header_bytes < n_bytes) damaged("cut off");
    return values_of(bytes.substr(encoding_.header_bytes), array_.type, n_, encoding_.is_big_endian);
  }

  std::string short_text() const {
    const std::string decoded = is_base64() ? this->decoded() : std::string();
    const std::string_view bytes = is_base64() ? std::string_view(decoded) : array_.content;
    const std::size_t first = word(bytes, 0);
    if (!encoding_.is_compressed) return first > n_ ? "" : std::string(bytes.substr(encoding_.header_bytes, first));
    if (first != 1) return "";
    const std::size_t full = word(bytes, 1), last = word(bytes, 2), n_bytes = last > 0 ? last : full;
    return n_bytes > n_ ? "" : expanded(bytes, n_bytes);
  }

 private:
  bool is_base64() const { return array_.format == XmlFormat::binary || encoding_.is_appended_base64; }

  [[noreturn]] void damaged(std::string_view why) const {
    throw_input_error("{}: the array '{}' is damaged, or the file was cut off ({})", path_, printable(array_.name, 60),
                      why);
  }

  std::vector<double> text_values() const {
    std::vector<double> values;
    std::string_view rest = array_.content;
    constexpr std::string_view blanks = " \t\r\n";
    if (n_ > rest.size() / 2 + 1) damaged(fmt::format("{} values do not fit into it", n_));
    values.reserve(n_);
    StopCheck stop_check;
    for (std::string_view text = next_word(rest, blanks); !text.empty(); text = next_word(rest, blanks)) {
      stop_check();
      const std::optional<double> value = to_double(text);
      if (!value) damaged(fmt::format("'{}' is no number", printable(text, 30)));
      if (values.size() == n_) damaged(fmt::format("at '{}'", printable(text, 30)));
      values.push_back(*value);
    }
    if (values.size() != n_) damaged(fmt::format("{} of {} values are there", values.size(), n_));
    return values;
  }

  std::string decoded() const {
    std::optional<std::string> bytes = decode_base64(array_.content);
    if (!bytes) damaged("no base64");
    return *std::move(bytes);
  }

  std::size_t word(std::string_view bytes, std::size_t i) const {
    const std::size_t size = encoding_.header_bytes;
    if (bytes.size() / size <= i) damaged("cut off");
    std::uint64_t value = 0;
    for (std::size_t k = 0; k < size; ++k)
      value = value << 8 | static_cast<unsigned char>(bytes[i * size + (encoding_.is_big_endian ? k : size - 1 - k)]);
    return value;
  }

  // Before the blocks stand their number, the bytes of a full one and of the last (0 if that is full), and their packed
  // sizes.
  std::string expanded(std::string_view bytes, std::size_t n_bytes) const {
    const std::size_t n_blocks = word(bytes, 0);
    if (n_blocks == 0) {
      if (n_bytes > 0) damaged("it has no values");
      return {};
    }
    const std::size_t full = word(bytes, 1), last = word(bytes, 2), n_words = bytes.size() / encoding_.header_bytes;
    if (n_blocks > n_words - 3 || last > full || full > std::numeric_limits<std::size_t>::max() / n_blocks)
      damaged("its blocks");
    if (n_blocks * full - (last > 0 ? full - last : 0) != n_bytes) damaged("the size of its blocks");
    std::string_view packed = bytes.substr((3 + n_blocks) * encoding_.header_bytes);
    // Memory is taken only for what the packed bytes can hold.
    if (n_bytes / max_expansion > packed.size()) damaged("cut off");
    std::string values(n_bytes, '\0');
    for (std::size_t i = 0, done = 0; i < n_blocks; ++i) {
      stop_if_wanted();
      const std::size_t size = word(bytes, 3 + i), n = std::min(full, n_bytes - done);
      if (size > packed.size()) damaged("cut off");
      if (!inflate_exactly(packed.substr(0, size), values.data() + done, n)) damaged("a block cannot be expanded");
      packed.remove_prefix(size);
      done += n;
    }
    return values;
  }

  const std::string& path_;
  const XmlArray& array_;
  const XmlEncoding& encoding_;
  std::size_t n_;
};

}  // namespace

std::vector<double> xml_values(const std::string& path, const XmlArray& array, const XmlEncoding& encoding,
                               std::size_t n) {
  return XmlValues(path, array, encoding, n).read();
}

std::string xml_bytes(const std::string& path, const XmlArray& array, const XmlEncoding& encoding, std::size_t most) {
  return XmlValues(path, array, encoding, most).short_text();
}

}  // namespace shellmatch
