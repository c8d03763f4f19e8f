// A loop whose calls write to the same memory: the thread sanitizer has to report it (tests/base/CMakeLists.txt).
#include "base/parallel.h"

#include <chrono>
#include <cstdio>
#include <thread>

int main() {
  shellmatch::set_n_threads(4);
  std::size_t sum = 0;
  const auto add = [&](std::size_t i) {
    sum += i;
    // Or the first thread would be done before the others begin.
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  };
  shellmatch::parallel_for(100, add, 1);
  std::printf("%zu\n", sum);
}
