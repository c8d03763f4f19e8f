#include "base/parallel.h"

#include "base/stop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <mutex>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace shellmatch {
namespace {

class Parallel : public ::testing::Test {
 protected:
  void TearDown() override {
    set_n_threads(0);
    stop_loops_when(nullptr);
  }
};

// Terms of very different size and sign: the order in which they are added shows in the last bits.
double term(std::size_t i) {
  return std::sin(static_cast<double>(i)) * std::pow(10.0, static_cast<double>(i % 17) - 8);
}

double sum_of_terms(std::size_t n, std::size_t chunk_size) {
  return parallel_sum(n, chunk_size, 0.0, [](const Chunk& c) {
    double s = 0;
    for (std::size_t i = c.begin; i < c.end; ++i) s += term(i);
    return s;
  });
}

bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

TEST_F(Parallel, SumsAreTheSameToTheBitForAnyNumberOfThreads) {
  set_n_threads(1);
  const double one = sum_of_terms(100'003, 64);
  for (const int threads : {2, 7}) {
    set_n_threads(threads);
    for (int repeat = 0; repeat < 5; ++repeat)
      EXPECT_TRUE(same_bits(one, sum_of_terms(100'003, 64))) << threads << " threads";
  }
}

// Shows that the test above can fail: another order of addition gives other bits.
TEST_F(Parallel, TheTermsTellOneOrderFromAnother) {
  set_n_threads(1);
  EXPECT_FALSE(same_bits(sum_of_terms(100'003, 64), sum_of_terms(100'003, 65)));
}

TEST_F(Parallel, ChunksCutTheRangeWithoutGapOrOverlap) {
  for (const std::size_t n : {1u, 63u, 64u, 65u, 1000u}) {
    std::vector<std::atomic<int>> visits(n);
    std::atomic<std::size_t> count = 0;
    parallel_chunks(n, 64, [&](const Chunk& c) {
      ++count;
      EXPECT_EQ(c.begin, c.index * 64);
      EXPECT_LT(c.begin, c.end);
      for (std::size_t i = c.begin; i < c.end; ++i) ++visits[i];
    });
    EXPECT_EQ(count, n_chunks(n, 64));
    for (const auto& v : visits) EXPECT_EQ(v, 1);
  }
}

TEST_F(Parallel, ForVisitsEveryIndexOnce) {
  std::vector<int> visits(5000, 0);
  parallel_for(
      visits.size(), [&](std::size_t i) { ++visits[i]; }, 7);
  EXPECT_EQ(std::accumulate(visits.begin(), visits.end(), 0), 5000);
  EXPECT_EQ(*std::max_element(visits.begin(), visits.end()), 1);
}

TEST_F(Parallel, AnEmptyRangeDoesNothing) {
  parallel_chunks(0, 64, [](const Chunk&) { FAIL(); });
  EXPECT_EQ(parallel_sum(0, 64, 3.5, [](const Chunk&) { return 1.0; }), 3.5);
}

TEST_F(Parallel, ExceptionsPassThroughWithAnyNumberOfThreads) {
  for (const int threads : {1, 2, 7}) {
    set_n_threads(threads);
    const auto body = [](std::size_t i) {
      if (i == 4321) throw std::runtime_error("at 4321");
    };
    EXPECT_THROW(parallel_for(10'000, body, 16), std::runtime_error) << threads << " threads";
  }
}

std::atomic<bool> stop_is_wanted = false;

// Within a loop too: one chunk may take long, but not all that are left.
TEST_F(Parallel, LoopsEndWhereAStopIsWanted) {
  stop_loops_when([] { return stop_is_wanted ? StopCause::time_limit : StopCause::none; });
  for (const int threads : {1, 2}) {
    set_n_threads(threads);
    std::atomic<std::size_t> done = 0;
    stop_is_wanted = false;
    EXPECT_NO_THROW(parallel_for(
        1000, [&](std::size_t) { ++done; }, 1));
    EXPECT_EQ(done, 1000u);
    done = 0;
    EXPECT_THROW(parallel_for(
                     1000, [&](std::size_t) { stop_is_wanted = ++done >= 10; }, 1),
                 Stopped);
    EXPECT_LT(done, 20u) << threads << " threads";
    try {
      parallel_for(1, [](std::size_t) {});
      ADD_FAILURE() << "the loop went on";
    } catch (const Stopped& stopped) {
      EXPECT_EQ(stopped.cause(), StopCause::time_limit);
    }
  }
  stop_loops_when(nullptr);
  EXPECT_NO_THROW(parallel_for(1, [](std::size_t) {}));
}

TEST_F(Parallel, SaysHowManyThreadsItUses) {
  set_n_threads(7);
  EXPECT_EQ(n_threads(), 7);
  set_n_threads(0);
  EXPECT_GE(n_threads(), 1);
}

TEST_F(Parallel, OneThreadStaysInTheCallersThread) {
  set_n_threads(1);
  std::mutex mutex;
  std::set<std::thread::id> ids;
  parallel_chunks(100, 1, [&](const Chunk&) {
    const std::lock_guard lock(mutex);
    ids.insert(std::this_thread::get_id());
  });
  EXPECT_EQ(ids, std::set<std::thread::id>{std::this_thread::get_id()});
}

// Sums of anything that adds, matrices for instance.
TEST_F(Parallel, SumsAnythingThatAdds) {
  const std::string text = parallel_sum(5, 1, std::string(), [](const Chunk& c) { return std::to_string(c.index); });
  EXPECT_EQ(text, "01234");
}

// A body that throws ends the loops within the others, which must not return as if they were done.
TEST_F(Parallel, ALoopWithinOneThatEndsDoesNotReturnWithChunksLeftOut) {
  set_n_threads(2);
  std::atomic<int> n_torn = 0;
  for (int round = 0; round < 100; ++round) {
    std::atomic<int> n_done = 0;
    try {
      for_both([&](int i) {
        if (i == 0) {
          for (int wait = 0; wait < 100000 && n_done < 500; ++wait) std::this_thread::yield();
          throw std::runtime_error("the end");
        }
        std::vector<char> done(20000, 0);
        parallel_for(
            done.size(), [&](std::size_t k) { done[k] = 1, ++n_done; }, 1);
        if (std::count(done.begin(), done.end(), 0) > 0) ++n_torn;
      });
    } catch (const std::runtime_error&) {
    }
  }
  EXPECT_EQ(n_torn, 0);
  set_n_threads(0);
}

}  // namespace
}  // namespace shellmatch
