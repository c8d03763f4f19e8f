#pragma once
/// \file
/// One number for each term of the energy.

#include <cstddef>
#include <vector>

namespace shellmatch {

/// Place of a term in lists of term values; energies/terms/term_names.h knows the names.
enum class Term : std::size_t {};

/// Weights of the terms, or weighted values. An energy with terms that are not in energies/terms/list.h has their
/// numbers after those of the list.
class TermValues {
 public:
  TermValues();  ///< 0 for each term of the list
  explicit TermValues(std::size_t n) : v_(n, 0.0) {}

  std::size_t size() const { return v_.size(); }
  double& operator[](Term t) { return v_[static_cast<std::size_t>(t)]; }
  double operator[](Term t) const { return v_[static_cast<std::size_t>(t)]; }
  double& operator[](std::size_t i) { return v_[i]; }
  double operator[](std::size_t i) const { return v_[i]; }
  auto begin() const { return v_.begin(); }
  auto end() const { return v_.end(); }

  /// Adds terms of value 0 at the end. \pre n >= size()
  void extend_to(std::size_t n) { v_.resize(n, 0.0); }

  TermValues& operator+=(const TermValues& o) {
    for (std::size_t i = 0; i < v_.size(); ++i) v_[i] += o.v_[i];
    return *this;
  }
  /// In the order of the terms.
  double sum() const {
    double s = 0;
    for (const double x : v_) s += x;
    return s;
  }

 private:
  std::vector<double> v_;
};

}  // namespace shellmatch
