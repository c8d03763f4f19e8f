#pragma once
/// \file
/// Results that take long, kept for a later computation of the same.

#include <chrono>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace shellmatch {

/// Results of one kind in the order in which they are asked for. Those that an earlier computation has left come first
/// and are not computed again: what asks always asks in the same order.
template <class T>
struct KeptResults {
  KeptResults() = default;
  KeptResults(std::vector<T> earlier, double their_seconds) : results(std::move(earlier)), seconds(their_seconds) {}

  std::vector<T> results;
  double seconds = 0;  ///< that they took

  /// \param keep makes of a result what stays of it
  template <class Compute, class Keep = std::identity>
  T next(const Compute& compute, const Keep& keep = {}) {
    if (n_taken_ < results.size()) return results[n_taken_++];
    const auto begin = std::chrono::steady_clock::now();
    T result = compute();
    seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    results.push_back(keep(result));
    ++n_taken_;
    return result;
  }

 private:
  std::size_t n_taken_ = 0;
};

}  // namespace shellmatch
