#pragma once
/// \file
/// Eight doubles as one value: one AVX-512 register, two AVX2 registers, or the compiler's equivalent. Kernels process
/// eight quadrature points at once.

#include "base/registers.h"

#include <Eigen/Core>

#include <cmath>

namespace shellmatch::autodiff {

inline constexpr int pack_size = 8;
typedef double Pack __attribute__((vector_size(sizeof(double) * pack_size)));
/// As many numbers in single precision, in which much is kept.
typedef float KeptPack __attribute__((vector_size(sizeof(float) * pack_size)));

inline Pack broadcast(Pack, double c) { return Pack{} + c; }
inline double broadcast(double, double c) { return c; }

/// Lane by lane `a` where x > y, else `b`; by registers (base/registers.h).
inline Pack where_greater(const Pack& x, const Pack& y, const Pack& a, const Pack& b) {
  constexpr std::size_t n_lanes = register_bytes / sizeof(double), n_parts = pack_size / n_lanes;
  using Lanes = Register<double, n_lanes>;
  const auto part = [](const Pack& from, std::size_t p) {
    return load<Lanes>(reinterpret_cast<const char*>(&from) + p * sizeof(Lanes));
  };
  Pack result;
  for (std::size_t p = 0; p < n_parts; ++p)
    store(part(x, p) > part(y, p) ? part(a, p) : part(b, p), reinterpret_cast<char*>(&result) + p * sizeof(Lanes));
  return result;
}

inline double max_of(double x, double y) { return x > y ? x : y; }
inline Pack max_of(const Pack& x, const Pack& y) { return where_greater(x, y, x, y); }

/// `d` where x > y, else 0: the derivative of max_of(x, y) with respect to x.
inline double where_greater(double x, double y, double d) { return x > y ? d : 0.0; }
inline Pack where_greater(const Pack& x, const Pack& y, const Pack& d) { return where_greater(x, y, d, Pack{}); }

inline double root_of(double x) { return std::sqrt(x); }
inline double exp_of(double x) { return std::exp(x); }
inline double log_of(double x) { return std::log(x); }
inline double pow_of(double x, double exponent) { return std::pow(x, exponent); }
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wuninitialized"  // false alarm of GCC 12 in its intrinsics, which begin with x = x
// The compiler may not vectorise std::sqrt, which can set errno. Eigen's square root is vectorised, as is its
// exponential, which is accurate to 1 or 2 units in the last place.
inline Pack root_of(Pack x) {
  Eigen::Map<Eigen::Array<double, pack_size, 1>, Eigen::Aligned64> lanes(reinterpret_cast<double*>(&x));
  lanes = lanes.sqrt().eval();
  return x;
}
inline Pack exp_of(Pack x) {
  Eigen::Map<Eigen::Array<double, pack_size, 1>, Eigen::Aligned64> lanes(reinterpret_cast<double*>(&x));
  lanes = lanes.exp().eval();
  return x;
}
#pragma GCC diagnostic pop
// Lane by lane: no term of the list calls these.
inline Pack log_of(Pack x) {
  for (int lane = 0; lane < pack_size; ++lane) x[lane] = std::log(x[lane]);
  return x;
}
inline Pack pow_of(Pack x, double exponent) {
  for (int lane = 0; lane < pack_size; ++lane) x[lane] = std::pow(x[lane], exponent);
  return x;
}

inline double sum_lanes(Pack x) { return ((x[0] + x[1]) + (x[2] + x[3])) + ((x[4] + x[5]) + (x[6] + x[7])); }

}  // namespace shellmatch::autodiff
