#pragma once
/// \file
/// Eight packs as a matrix, and its transpose: from one pack for each point to one pack for each quantity.

#include "energies/autodiff/pack.h"

#include <array>
#include <utility>

namespace shellmatch::autodiff {

namespace detail {

/// Exchanges a's upper and b's lower halves of all blocks of 2 * Size lanes.
template <int Size, std::size_t... Lane>
void exchange(Pack& a, Pack& b, std::index_sequence<Lane...>) {
  const Pack low = __builtin_shufflevector(a, b, ((Lane & Size) == 0 ? Lane : Lane - Size + pack_size)...);
  b = __builtin_shufflevector(a, b, ((Lane & Size) == 0 ? Lane + Size : Lane + pack_size)...);
  a = low;
}

template <int Size>
void exchange_blocks(std::array<Pack, pack_size>& rows) {
  for (int i = 0; i < pack_size; ++i)
    if ((i & Size) == 0) exchange<Size>(rows[i], rows[i + Size], std::make_index_sequence<pack_size>{});
}

}  // namespace detail

/// Transposes in place, in registers: blocks off the diagonal change places, of one lane, of two, of four.
inline void transpose(std::array<Pack, pack_size>& rows) {
  static_assert(pack_size == 8);
  detail::exchange_blocks<1>(rows);
  detail::exchange_blocks<2>(rows);
  detail::exchange_blocks<4>(rows);
}

}  // namespace shellmatch::autodiff
