#include "base/error.h"
#include "matching/output/checksum.h"

#include <xxhash.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <new>
#include <vector>

namespace shellmatch {

struct Checksum::State {
  XXH3_state_t* xxh3 = XXH3_createState();
  State() {
    if (xxh3 == nullptr || XXH3_64bits_reset(xxh3) != XXH_OK) throw std::bad_alloc();
  }
  ~State() { XXH3_freeState(xxh3); }
  State(const State&) = delete;
  State& operator=(const State&) = delete;
};

Checksum::Checksum() : state_(std::make_unique<State>()) {}
Checksum::~Checksum() = default;

Checksum& Checksum::add(std::string_view bytes) {
  XXH3_64bits_update(state_->xxh3, bytes.data(), bytes.size());
  return *this;
}

std::string Checksum::text() const { return fmt::format("{:016x}", XXH3_64bits_digest(state_->xxh3)); }

std::string text_checksum(std::string_view text) { return Checksum().add(text).text(); }

std::optional<std::string> stream_checksum(std::istream& in, std::uintmax_t length) {
  Checksum sum;
  std::vector<char> block(std::min<std::uintmax_t>(length, 1 << 20));
  while (length > 0) {
    const std::uintmax_t n = std::min<std::uintmax_t>(length, block.size());
    if (!in.read(block.data(), static_cast<std::streamsize>(n))) return std::nullopt;
    sum.add({block.data(), static_cast<std::size_t>(n)});
    length -= n;
  }
  return sum.text();
}

std::string file_checksum(const std::string& path) {
  std::error_code error;
  // Opening a pipe would wait for its other end.
  if (std::filesystem::exists(path, error) && !std::filesystem::is_regular_file(path, error))
    throw_input_error("{}: is no file; expected one that can be read", path);
  std::ifstream in(path, std::ios::binary);
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  const auto sum = in && !error ? stream_checksum(in, size) : std::nullopt;
  if (!sum) throw_input_error("{}: cannot be read; does the file exist, and may you read it?", path);
  return *sum;
}

}  // namespace shellmatch
