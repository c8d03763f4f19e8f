#pragma once
/// \file
/// A schedule for tasks that add to shared data: several threads run them without locks, and the results have the
/// same bits whatever the number of threads.

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

/// Tasks are coloured greedily in their order: two tasks of one colour access no datum in common. The additions to a
/// datum are made in the order of the colours. There is no barrier between colours: a task starts as soon as the
/// tasks of earlier colours that access its data have finished.
class ColouredSchedule {
 public:
  ColouredSchedule() = default;

  /// data_of(task) lists the data that a task accesses, as numbers in [0, n_data).
  template <class DataOf>
  ColouredSchedule(std::size_t n_tasks, std::size_t n_data, DataOf&& data_of) {
    constexpr int n_colours = 64;  // in one pass: one bit each
    std::vector<std::size_t> uncoloured(n_tasks);
    for (std::size_t i = 0; i < n_tasks; ++i) uncoloured[i] = i;
    while (!uncoloured.empty()) {  // one pass, unless a task has more than 63 neighbours
      std::vector<std::uint64_t> colours_at(n_data, 0);
      std::vector<std::vector<std::size_t>> tasks_of(n_colours);
      std::vector<std::size_t> left;
      for (const std::size_t task : uncoloured) {
        std::uint64_t of_neighbours = 0;
        for (const Index i : data_of(task)) of_neighbours |= colours_at[i];
        const int colour = std::countr_one(of_neighbours);
        if (colour == n_colours) {
          left.push_back(task);
          continue;
        }
        for (const Index i : data_of(task)) colours_at[i] |= std::uint64_t{1} << colour;
        tasks_of[colour].push_back(task);
      }
      for (const auto& tasks : tasks_of) tasks_.insert(tasks_.end(), tasks.begin(), tasks.end());
      uncoloured = std::move(left);
    }
    constexpr Index none = -1;
    std::vector<Index> last(n_data, none);  // by datum: position of the last task that accesses it
    predecessors_begin_.assign(1, 0);
    for (std::size_t k = 0; k < tasks_.size(); ++k) {
      const auto begin = static_cast<std::ptrdiff_t>(predecessors_.size());
      for (const Index i : data_of(tasks_[k])) {
        if (last[i] != none && last[i] != static_cast<Index>(k)) predecessors_.push_back(last[i]);
        last[i] = static_cast<Index>(k);
      }
      std::sort(predecessors_.begin() + begin, predecessors_.end());
      predecessors_.erase(std::unique(predecessors_.begin() + begin, predecessors_.end()), predecessors_.end());
      predecessors_begin_.push_back(predecessors_.size());
    }
  }

  /// All tasks, sorted by colour.
  std::span<const std::size_t> tasks() const { return tasks_; }
  /// Positions in tasks(), ascending and less than k, of the tasks that must finish before the k-th one starts: for
  /// each datum of that one, the last earlier task that accesses it.
  std::span<const Index> predecessors_of(std::size_t k) const {
    return {predecessors_.data() + predecessors_begin_[k], predecessors_begin_[k + 1] - predecessors_begin_[k]};
  }

  /// Calls body(task) for all tasks, in parallel where they access no datum in common. Exceptions propagate; no task
  /// starts after the first one.
  void run(auto&& body) const {
    const std::size_t n = tasks_.size();
    std::vector<std::atomic<int>> is_done(n);
    std::atomic<std::size_t> next = 0;
    // Threads take the tasks in order: the predecessors of a task have finished or are running. Hence no deadlock.
    parallel_chunks(std::min(n, static_cast<std::size_t>(n_threads())), 1, [&](const Chunk&) {
      for (std::size_t k = next++; k < n; k = next++) {
        struct Finish {  // a task that throws finishes too, or its successors would wait for ever
          std::atomic<int>& flag;
          ~Finish() {
            flag = 1;
            flag.notify_all();
          }
        } finish{is_done[k]};
        for (const Index p : predecessors_of(k)) is_done[p].wait(0);
        try {
          stop_if_wanted();
          body(tasks_[k]);
        } catch (...) {
          next = n;
          throw;
        }
      }
    });
  }

 private:
  std::vector<std::size_t> tasks_, predecessors_begin_;
  std::vector<Index> predecessors_;
};

}  // namespace shellmatch
