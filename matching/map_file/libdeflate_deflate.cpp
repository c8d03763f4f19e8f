#include "matching/map_file/deflate.h"

#include <libdeflate.h>

#include <memory>
#include <new>

namespace shellmatch {

namespace {

constexpr int least_effort = 1;

struct Free {
  void operator()(libdeflate_compressor* compressor) const { libdeflate_free_compressor(compressor); }
};

libdeflate_compressor& compressor() {
  thread_local const std::unique_ptr<libdeflate_compressor, Free> own(libdeflate_alloc_compressor(least_effort));
  if (!own) throw std::bad_alloc();
  return *own;
}

}  // namespace

std::size_t deflate_bound(std::size_t n) { return libdeflate_zlib_compress_bound(nullptr, n); }

std::size_t deflate(std::span<const unsigned char> data, std::span<unsigned char> stream) {
  return libdeflate_zlib_compress(&compressor(), data.data(), data.size(), stream.data(), stream.size());
}

}  // namespace shellmatch
