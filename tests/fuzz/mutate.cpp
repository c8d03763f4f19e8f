// The mutator that knows PNG: the checksums of its chunks are set right after each change, or every change would be
// refused for its checksum. Of other formats changes are those of the engine.
#include "tests/fuzz/target.h"

#include <zlib.h>

#include <cstdint>
#include <cstdlib>

/// The engine's own changes: libFuzzer's, or those of replay.cpp.
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned) {
  static const bool is_png = std::string_view(std::getenv("SHELLMATCH_FUZZ_TARGET")) == "png";
  size = LLVMFuzzerMutate(data, size, max_size);
  if (!is_png) return size;
  for (std::size_t at = 8; at + 12 <= size;) {
    const std::size_t length =
        std::size_t{data[at]} << 24 | std::size_t{data[at + 1]} << 16 | std::size_t{data[at + 2]} << 8 | data[at + 3];
    if (length > size - at - 12) break;
    const auto crc = static_cast<std::uint32_t>(crc32(0, data + at + 4, static_cast<uInt>(length + 4)));
    for (int k = 0; k < 4; ++k) data[at + 8 + length + k] = static_cast<std::uint8_t>(crc >> (24 - 8 * k));
    at += length + 12;
  }
  return size;
}
