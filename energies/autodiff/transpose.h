#pragma once
/// \file
/// Transpose of an 8 x 8 matrix of packs: from one pack for each point to one pack for each quantity.

#include "energies/autodiff/pack.h"

#include <array>
#include <utility>

namespace shellmatch::autodiff {

namespace detail {

/// Swaps the upper halves of a's blocks of 2 * Size lanes with the lower halves of b's.
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

/// Transposes in registers, in place: swaps off-diagonal blocks of one, two and four lanes in turn.
inline void transpose(std::array<Pack, pack_size>& rows) {
  static_assert(pack_size == 8);
  detail::exchange_blocks<1>(rows);
  detail::exchange_blocks<2>(rows);
  detail::exchange_blocks<4>(rows);
}

}  // namespace shellmatch::autodiff
