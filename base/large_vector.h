#pragma once
/// \file
/// Vectors on large memory pages, for large arrays with scattered accesses.

#include <cstddef>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace shellmatch {

/// Requests large pages from the operating system for this memory, which must not have been accessed yet. Has
/// no effect on systems without large pages.
void prefer_large_pages(void* memory, std::size_t bytes);

/// An allocator that requests large pages for large arrays, which reduces the cost of address translation.
/// Small arrays are allocated as by std::allocator. Default construction leaves numbers uninitialised, so
/// that the threads that write them are the first to touch their pages.
template <class T>
class LargePageAllocator {
 public:
  using value_type = T;
  LargePageAllocator() = default;
  template <class U>
  explicit(false) LargePageAllocator(const LargePageAllocator<U>&) noexcept {}

  T* allocate(std::size_t n) {
    const std::size_t bytes = n * sizeof(T);
    void* memory = ::operator new(bytes, alignment_of(n));
    if (is_large(n)) prefer_large_pages(memory, bytes);
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t n) noexcept { ::operator delete(memory, alignment_of(n)); }

  template <class U, class... Args>
  void construct(U* at, Args&&... args) {
    if constexpr (sizeof...(Args) == 0 && std::is_trivially_default_constructible_v<U>)
      ::new (static_cast<void*>(at)) U;
    else ::new (static_cast<void*>(at)) U(std::forward<Args>(args)...);
  }

  template <class U>
  bool operator==(const LargePageAllocator<U>&) const noexcept {
    return true;
  }

 private:
  static constexpr std::size_t page = std::size_t{1} << 21;  ///< bytes
  static bool is_large(std::size_t n) { return n * sizeof(T) >= 2 * page; }
  static std::align_val_t alignment_of(std::size_t n) { return std::align_val_t{is_large(n) ? page : alignof(T)}; }
};

/// \copydoc LargePageAllocator
template <class T>
using LargeVector = std::vector<T, LargePageAllocator<T>>;

}  // namespace shellmatch
