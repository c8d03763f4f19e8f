#include "geometry/volume/zlib_volume.h"

#include "base/error.h"

#include <zlib.h>

#include <algorithm>
#include <fstream>
#include <ios>
#include <memory>
#include <new>
#include <vector>

namespace shellmatch {

namespace {

constexpr std::size_t piece_size = 1 << 18;

// Collects what is passed on in whole pieces.
class Pieces {
 public:
  Pieces(std::uintmax_t skipped, std::uintmax_t n_bytes, const std::function<void(std::string_view)>& take)
      : skipped_(skipped), left_(n_bytes), take_(take) {
    buffer_.reserve(piece_size);
  }
  bool is_full() const { return left_ == 0; }
  void add(std::string_view bytes) {
    const std::size_t drop = static_cast<std::size_t>(std::min<std::uintmax_t>(skipped_, bytes.size()));
    skipped_ -= drop;
    bytes.remove_prefix(drop);
    bytes = bytes.substr(0, static_cast<std::size_t>(std::min<std::uintmax_t>(left_, bytes.size())));
    left_ -= bytes.size();
    n_ += bytes.size();
    while (!bytes.empty()) {
      const std::size_t n = std::min(bytes.size(), piece_size - buffer_.size());
      buffer_.append(bytes.substr(0, n));
      bytes.remove_prefix(n);
      if (buffer_.size() == piece_size) flush();
    }
  }
  std::uintmax_t end() {
    flush();
    return n_;
  }

 private:
  void flush() {
    if (!buffer_.empty()) take_(buffer_);
    buffer_.clear();
  }
  std::uintmax_t skipped_, left_, n_ = 0;
  const std::function<void(std::string_view)>& take_;
  std::string buffer_;
};

struct Inflation {
  Inflation() {
    constexpr int zlib_or_gzip = 15 + 32;
    if (inflateInit2(&stream, zlib_or_gzip) != Z_OK) throw std::bad_alloc();
  }
  ~Inflation() { inflateEnd(&stream); }
  Inflation(const Inflation&) = delete;
  Inflation& operator=(const Inflation&) = delete;
  z_stream stream{};
};

}  // namespace

bool is_gzip_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return file.get() == 0x1f && file.get() == 0x8b;
}

// gzread of zlib 1.3.2 takes a file whose first block is damaged for an empty one, without an error.
std::string inflated_beginning(const std::string& path, std::size_t n_bytes) {
  const bool is_compressed = is_gzip_file(path);
  std::ifstream file(path, std::ios::binary);
  if (!file) throw_input_error("{}: cannot be opened", path);
  std::string bytes(n_bytes, '\0'), in(is_compressed ? 1 << 16 : 0, '\0');
  if (!is_compressed) {
    file.read(bytes.data(), static_cast<std::streamsize>(n_bytes));
    bytes.resize(static_cast<std::size_t>(file.gcount()));
    return bytes;
  }
  Inflation inflation;
  z_stream& stream = inflation.stream;
  stream.next_out = reinterpret_cast<unsigned char*>(bytes.data());
  stream.avail_out = static_cast<unsigned>(n_bytes);
  bool is_behind_one = false;
  while (stream.avail_out > 0) {
    if (stream.avail_in == 0) {
      file.read(in.data(), static_cast<std::streamsize>(in.size()));
      stream.next_in = reinterpret_cast<unsigned char*>(in.data());
      stream.avail_in = static_cast<unsigned>(file.gcount());
      if (stream.avail_in == 0) break;
    }
    const int status = inflate(&stream, Z_NO_FLUSH);
    // A file may be several streams one after another, and what follows the last is no error.
    if (status == Z_STREAM_END) {
      is_behind_one = true;
      if (inflateReset(&stream) != Z_OK) break;
    } else if (status != Z_OK && status != Z_BUF_ERROR) {
      if (is_behind_one) break;
      throw_input_error("{}: its compressed data are damaged; copy or export the file again", path);
    }
  }
  bytes.resize(n_bytes - stream.avail_out);
  return bytes;
}

std::uintmax_t for_each_piece(const std::string& path, std::uintmax_t offset, bool deflated, std::uintmax_t skipped,
                              std::uintmax_t n_bytes, const std::function<void(std::string_view)>& take) {
  std::ifstream file(path, std::ios::binary);
  file.seekg(static_cast<std::streamoff>(offset));
  Pieces pieces(skipped, n_bytes, take);
  std::string in(1 << 16, '\0'), out(deflated ? piece_size : 0, '\0');
  Inflation inflation;
  z_stream& stream = inflation.stream;
  while (!pieces.is_full()) {
    file.read(in.data(), static_cast<std::streamsize>(in.size()));
    const auto n = static_cast<std::size_t>(file.gcount());
    if (n == 0) break;
    if (!deflated) {
      pieces.add(std::string_view(in).substr(0, n));
      continue;
    }
    stream.next_in = reinterpret_cast<unsigned char*>(in.data());
    stream.avail_in = static_cast<unsigned>(n);
    do {
      stream.next_out = reinterpret_cast<unsigned char*>(out.data());
      stream.avail_out = static_cast<unsigned>(out.size());
      const int status = inflate(&stream, Z_NO_FLUSH);
      pieces.add(std::string_view(out).substr(0, out.size() - stream.avail_out));
      // A file may be several streams one after another.
      if (status == Z_STREAM_END ? inflateReset(&stream) != Z_OK : status != Z_OK && status != Z_BUF_ERROR)
        return pieces.end();
    } while (!pieces.is_full() && (stream.avail_in > 0 || stream.avail_out == 0));
  }
  return pieces.end();
}

std::string deflated(std::string_view bytes, Deflated form) {
  z_stream stream{};
  if (deflateInit2(&stream, Z_BEST_SPEED, Z_DEFLATED, form == Deflated::gzip ? 15 + 16 : 15, 8, Z_DEFAULT_STRATEGY) !=
      Z_OK)
    throw std::bad_alloc();
  const std::unique_ptr<z_stream, int (*)(z_stream*)> end(&stream, deflateEnd);
  std::string result, out(piece_size, '\0');
  while (true) {
    // zlib counts in 32 bits.
    const std::string_view in = bytes.substr(0, std::size_t{1} << 30);
    bytes.remove_prefix(in.size());
    stream.next_in = reinterpret_cast<unsigned char*>(const_cast<char*>(in.data()));
    stream.avail_in = static_cast<unsigned>(in.size());
    do {
      stream.next_out = reinterpret_cast<unsigned char*>(out.data());
      stream.avail_out = static_cast<unsigned>(out.size());
      deflate(&stream, bytes.empty() ? Z_FINISH : Z_NO_FLUSH);
      result.append(out, 0, out.size() - stream.avail_out);
    } while (stream.avail_out == 0);
    if (bytes.empty()) return result;
  }
}

}  // namespace shellmatch
