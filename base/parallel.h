#pragma once
/// \file
/// Parallel loops whose results do not depend on the number of threads: the range is divided into chunks of
/// fixed length, one thread processes each chunk in order, and partial sums are added in the order of the
/// chunks.

#include <cstddef>
#include <functional>
#include <vector>

namespace shellmatch {

/// Sets the number of threads of the loops below; 0 means all of the machine. Must not be called from within
/// a loop.
void set_n_threads(int n);
int n_threads();

/// The part [begin, end) of a range; `index` is its number.
struct Chunk {
  std::size_t begin, end, index;
};

/// Number of chunks of [0, n).
inline std::size_t n_chunks(std::size_t n, std::size_t chunk_size) { return (n + chunk_size - 1) / chunk_size; }

/// Calls body(chunk) for every chunk of [0, n), in parallel. Exceptions of `body` are passed to the caller.
void parallel_chunks(std::size_t n, std::size_t chunk_size, const std::function<void(const Chunk&)>& body);

/// Calls body(i) for i in [0, n), in parallel. Calls for different i must not write to the same memory.
void parallel_for(std::size_t n, auto&& body, std::size_t chunk_size = 1024) {
  parallel_chunks(n, chunk_size, [&](const Chunk& c) {
    for (std::size_t i = c.begin; i < c.end; ++i) body(i);
  });
}

/// Calls body(0) and body(1), in parallel where there are threads: for work on two shapes with serial parts.
void for_both(auto&& body) {
  parallel_chunks(2, 1, [&](const Chunk& c) { body(static_cast<int>(c.index)); });
}

/// Sum of body(chunk) over all chunks, added in the order of the chunks.
template <class T, class Body>
T parallel_sum(std::size_t n, std::size_t chunk_size, T zero, Body&& body) {
  std::vector<T> parts(n_chunks(n, chunk_size), zero);
  parallel_chunks(n, chunk_size, [&](const Chunk& c) { parts[c.index] = body(c); });
  T sum = zero;
  for (const T& p : parts) sum += p;
  return sum;
}

}  // namespace shellmatch
