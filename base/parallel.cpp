#include "base/parallel.h"

#include "base/error.h"
#include "base/stop.h"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <stdexcept>
#include <string_view>

namespace shellmatch {

namespace {
// Never destroyed: when a limit ends, TBB starts the threads that it withheld, and a program that is about to end would be
// terminated where the system has no room for them.
tbb::global_control* limit = nullptr;
int threads = 0;

// TBB tells that the system refuses a thread by a std::runtime_error of this text alone.
bool says_no_thread(const std::runtime_error& error) { return std::string_view(error.what()).find("pthread_create") != std::string_view::npos; }
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
    tbb::parallel_for(std::size_t{0}, count, run);
  } catch (const std::runtime_error& error) {
    if (says_no_thread(error)) throw_environment_error("the system starts no further thread ({}); --threads 1 needs none", error.what());
    throw;
  }
}

}  // namespace shellmatch
