#include "tests/fuzz/run_input.h"

#include "base/error.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>

// Of the address sanitizer. clang has them in <sanitizer/allocator_interface.h>, which g++ lacks.
extern "C" int __sanitizer_install_malloc_and_free_hooks(void (*on_malloc)(const volatile void*, std::size_t),
                                                         void (*on_free)(const volatile void*));
extern "C" std::size_t __sanitizer_get_allocated_size(const volatile void*);

namespace shellmatch::fuzz {

namespace {

// Of this thread, while a reader runs.
thread_local bool is_counting = false;
thread_local std::int64_t held = 0, most_held = 0;

void on_allocation(const volatile void*, std::size_t n) {
  if (!is_counting) return;
  held += static_cast<std::int64_t>(n);
  most_held = std::max(most_held, held);
}

void on_release(const volatile void* memory) {
  if (is_counting && memory != nullptr) held -= static_cast<std::int64_t>(__sanitizer_get_allocated_size(memory));
}

struct Counting {
  Counting() {
    [[maybe_unused]] static const int installed = __sanitizer_install_malloc_and_free_hooks(on_allocation, on_release);
    held = most_held = 0;
    is_counting = true;
  }
  ~Counting() { is_counting = false; }
};

}  // namespace

std::string run_input(const Target& target, std::string_view bytes) {
  const std::string copy(bytes);
  std::string refusal;
  const Counting counting;
  try {
    target.read(copy);
  } catch (const InputError& error) {
    demand(error.what()[0] != '\0', "a refusal says why");
    refusal = error.what();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "an exception that is no InputError: %s\n", error.what());
    std::abort();
  }
  const auto limit = static_cast<std::int64_t>(target.most_bytes + target.most_bytes_per_byte * bytes.size());
  if (most_held <= limit) return refusal;
  std::fprintf(stderr, "memory: %lld bytes for an input of %zu, the limit is %lld\n", static_cast<long long>(most_held),
               bytes.size(), static_cast<long long>(limit));
  std::abort();
}

}  // namespace shellmatch::fuzz
