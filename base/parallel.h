#pragma once
/// \file
/// Parallel loops whose results do not depend on the number of threads: the range is cut into chunks of a
/// fixed length, every chunk is worked off by one thread in order, and sums are added up in chunk order.

#include <cstddef>
#include <functional>
#include <vector>

namespace shellmatch {

/// Number of threads that the loops below use from now on; 0 means all of the machine. Not to be called
/// from within a loop.
void set_n_threads(int n);
int n_threads();

/// A piece [begin, end) of a range; `index` counts the pieces.
struct Chunk {
  std::size_t begin, end, index;
};

/// Number of chunks that [0, n) is cut into.
inline std::size_t n_chunks(std::size_t n, std::size_t chunk_size) { return (n + chunk_size - 1) / chunk_size; }

/// Calls body(chunk) for every chunk of [0, n), in parallel. Exceptions pass through.
void parallel_chunks(std::size_t n, std::size_t chunk_size, const std::function<void(const Chunk&)>& body);

/// Calls body(i) for i in [0, n), in parallel. Only for bodies that write to places of their own.
template <class Body>
void parallel_for(std::size_t n, Body&& body, std::size_t chunk_size = 1024) {
  parallel_chunks(n, chunk_size, [&](const Chunk& c) {
    for (std::size_t i = c.begin; i < c.end; ++i) body(i);
  });
}

/// Calls body(0) and body(1), at the same time where there are threads: for two shapes, whose work has parts that
/// only one thread can do.
template <class Body>
void for_both(Body&& body) {
  parallel_chunks(2, 1, [&](const Chunk& c) { body(static_cast<int>(c.index)); });
}

/// Sum of body(chunk) over all chunks, added in chunk order: the same bits whatever the number of threads.
template <class T, class Body>
T parallel_sum(std::size_t n, std::size_t chunk_size, T zero, Body&& body) {
  std::vector<T> parts(n_chunks(n, chunk_size), zero);
  parallel_chunks(n, chunk_size, [&](const Chunk& c) { parts[c.index] = body(c); });
  T sum = zero;
  for (const T& p : parts) sum += p;
  return sum;
}

}  // namespace shellmatch
