#include "apps/cohorts/output/npy_file.h"

#include "base/error.h"
#include "base/replace_file.h"

#include <bit>
#include <fstream>
#include <functional>
#include <numeric>

namespace shellmatch {

namespace {

static_assert(std::endian::native == std::endian::little, "the bytes of values are written as they are");

std::string npy_head(const std::string& type, const std::vector<std::size_t>& shape) {
  std::string lengths;
  for (const std::size_t n : shape) lengths += fmt::format("{}, ", n);
  std::string text = fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({}), }}", type, lengths);
  // The format wants the values to begin at a multiple of 64 bytes, and the head to end with a new line.
  constexpr std::size_t before = 10, alignment = 64;
  text.append((alignment - (before + text.size() + 1) % alignment) % alignment, ' ');
  text += '\n';
  std::string head = "\x93NUMPY";
  head += '\x01';
  head += '\0';
  head += static_cast<char>(text.size() & 0xff);
  head += static_cast<char>(text.size() >> 8);
  return head + text;
}

template <class Value>
void write_values(const std::string& path, const std::string& type, const std::vector<std::size_t>& shape,
                  std::span<const Value> values) {
  SHELLMATCH_CHECK(std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>()) == values.size(),
                   "the shape is that of the values");
  replace_file(path, [&](const std::string& file) {
    std::ofstream out(file, std::ios::binary);
    const std::string head = npy_head(type, shape);
    out.write(head.data(), static_cast<std::streamsize>(head.size()));
    out.write(reinterpret_cast<const char*>(values.data()), static_cast<std::streamsize>(values.size_bytes()));
    if (!out.flush()) cannot_be_written(0, fmt::format("{}: cannot be written; is the disk full?", path));
  });
}

}  // namespace

void write_npy(const std::string& path, const std::vector<std::size_t>& shape, std::span<const double> values) {
  write_values(path, "<f8", shape, values);
}

void write_npy(const std::string& path, const std::vector<std::size_t>& shape, std::span<const std::int32_t> values) {
  write_values(path, "<i4", shape, values);
}

}  // namespace shellmatch
