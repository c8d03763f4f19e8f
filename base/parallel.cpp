#include "base/parallel.h"

#include "base/error.h"
#include "base/stop.h"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <new>
#include <stdexcept>
#include <string_view>
#include <thread>

namespace shellmatch {

namespace {
// Never destroyed: when a limit ends, TBB starts the threads that it withheld, and a program that is about to end would
// be terminated where the system has no room for them.
tbb::global_control* limit = nullptr;
int threads = 0;

// TBB tells that the system refuses a thread by a std::runtime_error of this text alone.
bool says_no_thread(const std::runtime_error& error) {
  return std::string_view(error.what()).find("pthread_create") != std::string_view::npos;
}

#if defined(__SANITIZE_THREAD__)
// The thread sanitizer does not see how TBB, whose libraries are not compiled with it, hands calls to threads and waits
// for them: it would report every loop. These threads it sees begin and end, and nothing else orders the calls of
// different threads.
template <class Call>
void run_on_threads(std::size_t count, const Call& call) {
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  std::exception_ptr first;
  const auto work = [&] {
    try {
      for (std::size_t k = next.fetch_add(1, std::memory_order_relaxed); k < count;
           k = next.fetch_add(1, std::memory_order_relaxed))
        call(k);
    } catch (...) {
      next.store(count, std::memory_order_relaxed);
      const std::lock_guard lock(mutex);
      if (!first) first = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> others;
    while (others.size() + 1 < std::min(count, static_cast<std::size_t>(n_threads()))) others.emplace_back(work);
    work();
  }
  if (first) std::rethrow_exception(first);
}
#else
// Where an allocation fails while oneTBB 2022 starts, its function that would throw waits for ever. The start needs
// less than this, which is given back at once.
void make_room_to_start() {
  constexpr std::size_t bytes = 4 << 20;
  thread_local bool started = false;
  if (!started) ::operator delete(::operator new(bytes));
  started = true;
}

template <class Call>
void run_on_threads(std::size_t count, const Call& call) {
  make_room_to_start();
  tbb::parallel_for(std::size_t{0}, count, call);
  // Where a body of an enclosing loop has thrown, TBB cancels the loops within the others: they return without an
  // exception and with chunks left out. Whoever goes on would compute with half of the data. The enclosing loop throws
  // what came first.
  if (tbb::is_current_task_group_canceling()) throw Stopped("stopped, as another part of the computation has ended");
}
#endif
}  // namespace

void set_n_threads(int n) {
  threads = n > 0 ? n : tbb::info::default_concurrency();
  // The smallest of the limits that exist holds: the new one comes before the earlier one goes.
  auto* const earlier = limit;
  limit = new tbb::global_control(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  delete earlier;
}

int n_threads() { return threads > 0 ? threads : tbb::info::default_concurrency(); }

void parallel_chunks(std::size_t n, std::size_t chunk_size, const std::function<void(const Chunk&)>& body) {
  const std::size_t count = n_chunks(n, chunk_size);
  const auto run = [&](std::size_t k) {
    stop_if_wanted();
    body({k * chunk_size, std::min(n, (k + 1) * chunk_size), k});
  };
  if (count <= 1 || threads == 1) {
    for (std::size_t k = 0; k < count; ++k) run(k);
    return;
  }
  try {
    run_on_threads(count, run);
  } catch (const std::runtime_error& error) {
    if (says_no_thread(error))
      throw_environment_error("the system starts no further thread ({}); --threads 1 needs none", error.what());
    throw;
  }
}

}  // namespace shellmatch
