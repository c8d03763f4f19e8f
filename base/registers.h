#pragma once
/// \file
/// Vectors of the compiler (`vector_size`) that are as wide as a register of the processor. g++ compares and selects
/// the numbers of wider ones one after the other.

#include <array>
#include <cstddef>
#include <cstring>

#ifdef __SSE2__
#include <immintrin.h>
#endif

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

/// Numbers of single precision in double precision. g++ 12 takes five instructions for what processors do by one.
inline Register<double, 2> widened(const Register<float, 2>& x) {
#ifdef __SSE2__
  return _mm_cvtps_pd(_mm_castsi128_ps(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(&x))));
#else
  return __builtin_convertvector(x, Register<double, 2>);
#endif
}
inline Register<double, 4> widened(const Register<float, 4>& x) {
#ifdef __AVX__
  return _mm256_cvtps_pd(x);
#else
  return __builtin_convertvector(x, Register<double, 4>);
#endif
}
inline Register<double, 8> widened(const Register<float, 8>& x) {
#ifdef __AVX512F__
  return _mm512_maskz_cvtps_pd(0xff, x);  // g++ 12 warns of undefined lanes without the mask (GCC bug 105593)
#else
  return __builtin_convertvector(x, Register<double, 8>);
#endif
}

}  // namespace shellmatch
