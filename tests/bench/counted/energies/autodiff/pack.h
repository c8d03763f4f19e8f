#pragma once
/// \file
/// Stands in the place of the real energies/autodiff/pack.h when tests/bench/count_flops compiles the energies: one
/// lane whose arithmetic is counted. So the very loops of the program are counted and no copy of them.
///
/// Logarithms and powers count as exponentials, which cost about the same.
///
/// Adding to a Pack that was only just made, Pack{} + 1.0 or the first term of a sum, is not counted: it
/// costs nothing.

#include <cmath>

namespace shellmatch::autodiff {

struct OperationCount {
  long additions = 0, multiplications = 0, divisions = 0, roots = 0, exponentials = 0;
  OperationCount operator-(const OperationCount& o) const {
    return {additions - o.additions, multiplications - o.multiplications, divisions - o.divisions, roots - o.roots,
            exponentials - o.exponentials};
  }
};
inline OperationCount counted;  // by one thread

inline constexpr int pack_size = 1;

class Pack {
 public:
  Pack() = default;

  double& operator[](int) {
    is_new_ = false;
    return value_;
  }
  const double& operator[](int) const { return value_; }

  friend Pack operator+(const Pack& x, const Pack& y) { return x.sum(y.value_, y.is_new_); }
  friend Pack operator+(const Pack& x, double y) { return x.sum(y, false); }
  friend Pack operator+(double x, const Pack& y) { return y.sum(x, false); }
  friend Pack operator-(const Pack& x, const Pack& y) { return x.sum(-y.value_, y.is_new_); }
  friend Pack operator-(const Pack& x, double y) { return x.sum(-y, false); }
  friend Pack operator-(double x, const Pack& y) { return Pack(-y.value_).sum(x, false); }
  friend Pack operator-(const Pack& x) { return Pack(-x.value_); }  // a turned sign goes into what follows
  friend Pack operator*(const Pack& x, const Pack& y) { return product(x.value_, y.value_); }
  friend Pack operator*(const Pack& x, double y) { return product(x.value_, y); }
  friend Pack operator*(double x, const Pack& y) { return product(x, y.value_); }
  friend Pack operator/(const Pack& x, const Pack& y) { return quotient(x.value_, y.value_); }
  friend Pack operator/(const Pack& x, double y) { return quotient(x.value_, y); }
  friend Pack operator/(double x, const Pack& y) { return quotient(x, y.value_); }
  Pack& operator+=(const Pack& y) { return *this = *this + y; }
  Pack& operator-=(const Pack& y) { return *this = *this - y; }
  Pack& operator*=(const Pack& y) { return *this = *this * y; }
  Pack& operator*=(double y) { return *this = *this * y; }
  Pack& operator/=(const Pack& y) { return *this = *this / y; }

  // One lane: what chooses between two packs lane by lane is a plain bool.
  friend bool operator<(const Pack& x, const Pack& y) { return x.value_ < y.value_; }
  friend bool operator>(const Pack& x, const Pack& y) { return x.value_ > y.value_; }
  friend bool operator>(const Pack& x, double y) { return x.value_ > y; }
  friend bool operator>=(const Pack& x, double y) { return x.value_ >= y; }

  friend Pack root_of(const Pack& x);
  friend Pack exp_of(const Pack& x);
  friend Pack log_of(const Pack& x);
  friend Pack pow_of(const Pack& x, double exponent);

 private:
  explicit Pack(double value) : value_(value), is_new_(false) {}
  Pack sum(double y, bool y_is_new) const {
    if (!is_new_ && !y_is_new) ++counted.additions;
    return Pack(value_ + y);
  }
  static Pack product(double x, double y) {
    ++counted.multiplications;
    return Pack(x * y);
  }
  static Pack quotient(double x, double y) {
    ++counted.divisions;
    return Pack(x / y);
  }
  double value_ = 0;
  bool is_new_ = true;
};

inline Pack root_of(const Pack& x) {
  ++counted.roots;
  return Pack(std::sqrt(x.value_));
}
inline Pack exp_of(const Pack& x) {
  ++counted.exponentials;
  return Pack(std::exp(x.value_));
}
inline Pack log_of(const Pack& x) {
  ++counted.exponentials;
  return Pack(std::log(x.value_));
}
inline Pack pow_of(const Pack& x, double exponent) {
  ++counted.exponentials;
  return Pack(std::pow(x.value_, exponent));
}
inline Pack broadcast(const Pack&, double c) { return Pack{} + c; }
inline double broadcast(double, double c) { return c; }
inline double max_of(double x, double y) { return x > y ? x : y; }
inline Pack max_of(const Pack& x, const Pack& y) { return x > y ? x : y; }
inline double where_greater(double x, double y, double d) { return x > y ? d : 0.0; }
inline Pack where_greater(const Pack& x, const Pack& y, const Pack& d) { return x > y ? d : Pack{}; }
inline double root_of(double x) { return std::sqrt(x); }
inline double exp_of(double x) { return std::exp(x); }
inline double log_of(double x) { return std::log(x); }
inline double pow_of(double x, double exponent) { return std::pow(x, exponent); }
inline double sum_lanes(const Pack& x) { return x[0]; }

}  // namespace shellmatch::autodiff
