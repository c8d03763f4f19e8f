#include "base/parallel.h"

#include "base/stop.h"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <memory>

namespace shellmatch {

namespace {
std::unique_ptr<tbb::global_control> limit;
int threads = 0;
}  // namespace

void set_n_threads(int n) {
  threads = n > 0 ? n : tbb::info::default_concurrency();
  limit = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                static_cast<std::size_t>(threads));
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
  tbb::parallel_for(std::size_t{0}, count, run);
}

}  // namespace shellmatch
