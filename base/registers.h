#pragma once
/// \file
/// Vectors of the compiler (`vector_size`) that are as wide as a register of the processor. g++ compares and selects
/// the numbers of wider ones one after the other.

#include <array>
#include <cstddef>
#include <cstring>

namespace shellmatch {

#if defined(__AVX512F__)
inline constexpr std::size_t register_bytes = 64;
#elif defined(__AVX__)
inline constexpr std::size_t register_bytes = 32;
#else
inline constexpr std::size_t register_bytes = 16;
#endif

/// n numbers, as a vector.
template <class T, std::size_t n>
struct RegisterOf {
  typedef T type __attribute__((vector_size(n * sizeof(T))));
};
template <class T, std::size_t n>
using Register = typename RegisterOf<T, n>::type;

/// The vector of the numbers that begin at `from`.
template <class V, class T>
inline V load(const T* from) {
  V v;
  std::memcpy(&v, from, sizeof v);
  return v;
}
template <class V, class T>
inline void store(const V& v, T* to) {
  std::memcpy(to, &v, sizeof v);
}

}  // namespace shellmatch
