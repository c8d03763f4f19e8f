#pragma once
/// \file
/// A hash map of 64 bit keys to indices, insertion only.

#include "base/types.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace shellmatch {

/// Open addressing with linear probing in a table of a power of two slots, at most half full, and Fibonacci
/// hashing (Knuth, The Art of Computer Programming, vol. 3, section 6.4), which spreads the regular keys of a
/// grid evenly. Nothing is ever erased.
class KeyMap {
 public:
  /// A key that is never stored.
  static constexpr std::uint64_t no_key = ~std::uint64_t{0};

  KeyMap() { allocate(16); }

  /// The value stored with `key`, or no_index.
  Index find(std::uint64_t key) const {
    for (std::size_t i = start(key);; i = (i + 1) & mask_) {
      if (slots_[i].key == key) return slots_[i].value;
      if (slots_[i].key == no_key) return no_index;
    }
  }

  /// Stores `value` unless the key is there already; returns what is stored now. \pre key != no_key
  Index insert(std::uint64_t key, Index value) {
    if (2 * (size_ + 1) > slots_.size()) rehash(2 * slots_.size());
    for (std::size_t i = start(key);; i = (i + 1) & mask_) {
      if (slots_[i].key == key) return slots_[i].value;
      if (slots_[i].key == no_key) {
        slots_[i] = {key, value};
        ++size_;
        return value;
      }
    }
  }

  std::size_t size() const { return size_; }

 private:
  struct Slot {
    std::uint64_t key = no_key;
    Index value = no_index;
  };

  // 2^64 over the golden ratio; the upper bits of the product are the well mixed ones.
  std::size_t start(std::uint64_t key) const { return (key * 0x9E3779B97F4A7C15u) >> shift_; }

  void allocate(std::size_t n_slots) {
    slots_.assign(n_slots, Slot{});
    mask_ = n_slots - 1;
    shift_ = 64 - std::countr_zero(n_slots);
  }

  void rehash(std::size_t n_slots) {
    const std::vector<Slot> old = std::move(slots_);
    allocate(n_slots);
    size_ = 0;
    for (const Slot& s : old)
      if (s.key != no_key) insert(s.key, s.value);
  }

  std::vector<Slot> slots_;
  std::size_t size_ = 0, mask_ = 0;
  int shift_ = 0;
};

}  // namespace shellmatch
