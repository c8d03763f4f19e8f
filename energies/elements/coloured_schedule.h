#pragma once
/// \file
/// Pieces of work that add to shared numbers: an order in which they can be done by several threads, without locks
/// and with the same bits whatever the number of threads.

#include "base/parallel.h"
#include "base/stop.h"
#include "base/types.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace shellmatch {

/// Pieces of one wave touch nothing in common, by greedy colouring of the pieces in their order. What is added to a
/// number comes in the order of the waves; but no wave is waited for as a whole: a piece may begin as soon as those
/// pieces of earlier waves are done which touch what it touches.
class ColouredSchedule {
 public:
  ColouredSchedule() = default;

  /// touched(piece) lists what a piece touches, numbers in [0, n_numbers).
  template <class Touched>
  ColouredSchedule(std::size_t n_pieces, std::size_t n_numbers, Touched&& touched) {
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
      for (const auto& wave : found) pieces_.insert(pieces_.end(), wave.begin(), wave.end());
      waiting = std::move(left);
    }
    constexpr Index nobody = -1;
    std::vector<Index> last(n_numbers, nobody);  // by number: who touched it last
    first_predecessor_.assign(1, 0);
    for (std::size_t k = 0; k < pieces_.size(); ++k) {
      const auto begin = static_cast<std::ptrdiff_t>(predecessors_.size());
      for (const Index i : touched(pieces_[k])) {
        if (last[i] != nobody && last[i] != static_cast<Index>(k)) predecessors_.push_back(last[i]);
        last[i] = static_cast<Index>(k);
      }
      std::sort(predecessors_.begin() + begin, predecessors_.end());
      predecessors_.erase(std::unique(predecessors_.begin() + begin, predecessors_.end()), predecessors_.end());
      first_predecessor_.push_back(predecessors_.size());
    }
  }

  /// All pieces in the order of the waves.
  std::span<const std::size_t> pieces() const { return pieces_; }
  /// Places in that order, ascending and before k, of those that have to be done before the piece at place k, as they
  /// are the last that touched something of it.
  std::span<const Index> predecessors_of(std::size_t k) const {
    return {predecessors_.data() + first_predecessor_[k], first_predecessor_[k + 1] - first_predecessor_[k]};
  }

  /// Calls body(piece) for all, in parallel where they touch nothing in common. Exceptions pass through.
  template <class Body>
  void run(Body&& body) const {
    const std::size_t n = pieces_.size();
    std::vector<std::atomic<int>> is_done(n);
    std::atomic<std::size_t> next = 0;
    // Pieces are taken in order: those that one waits for are done, or somebody is at work on them.
    parallel_chunks(std::min(n, static_cast<std::size_t>(n_threads())), 1, [&](const Chunk&) {
      for (std::size_t k = next++; k < n; k = next++) {
        struct Done {
          std::atomic<int>& it;
          ~Done() {
            it = 1;
            it.notify_all();
          }
        } done{is_done[k]};  // even if it fails, or others would wait for ever
        for (const Index p : predecessors_of(k)) is_done[p].wait(0);
        try {
          stop_if_wanted();
          body(pieces_[k]);
        } catch (...) {
          next = n;
          throw;
        }
      }
    });
  }

 private:
  std::vector<std::size_t> pieces_, first_predecessor_;
  std::vector<Index> predecessors_;
};

}  // namespace shellmatch
