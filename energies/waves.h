#pragma once
/// \file
/// Pieces of work that add to shared numbers: an order in which they can be done by several threads, without locks
/// and with the same bits whatever the number of threads.

#include "base/parallel.h"
#include "base/types.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace shellmatch {

/// Pieces of one wave touch nothing in common and are done at the same time, waves one after the other: greedy
/// colouring of the pieces, in their order. What is added to a number comes in the order of the waves.
class Waves {
 public:
  Waves() = default;

  /// touched(piece) lists what a piece touches, numbers in [0, n_numbers).
  template <class Touched>
  Waves(std::size_t n_pieces, std::size_t n_numbers, Touched&& touched) {
    constexpr int colours_at_once = 64;
    std::vector<std::size_t> waiting(n_pieces);
    for (std::size_t i = 0; i < n_pieces; ++i) waiting[i] = i;
    while (!waiting.empty()) {  // once, unless some piece has more than 63 neighbours
      std::vector<std::uint64_t> taken(n_numbers, 0);
      std::vector<std::vector<std::size_t>> found(colours_at_once);
      std::vector<std::size_t> left;
      for (const std::size_t piece : waiting) {
        std::uint64_t around = 0;
        for (const Index i : touched(piece)) around |= taken[i];
        const int colour = std::countr_one(around);
        if (colour == colours_at_once) {
          left.push_back(piece);
          continue;
        }
        for (const Index i : touched(piece)) taken[i] |= std::uint64_t{1} << colour;
        found[colour].push_back(piece);
      }
      for (const auto& wave : found)
        if (!wave.empty()) {
          pieces_.insert(pieces_.end(), wave.begin(), wave.end());
          ends_.push_back(pieces_.size());
        }
      waiting = std::move(left);
    }
  }

  /// All pieces in the order of the waves, and where in it each wave ends.
  std::span<const std::size_t> pieces() const { return pieces_; }
  std::span<const std::size_t> ends() const { return ends_; }

  /// Calls body(piece) for all, those of one wave in parallel.
  template <class Body>
  void run(Body&& body) const {
    std::size_t begin = 0;
    for (const std::size_t end : ends_) {
      parallel_chunks(end - begin, 1, [&](const Chunk& c) { body(pieces_[begin + c.begin]); });
      begin = end;
    }
  }

 private:
  std::vector<std::size_t> pieces_, ends_;
};

}  // namespace shellmatch
