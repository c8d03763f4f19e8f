#pragma once
/// \file
/// Stands in the place of the real energies/autodiff/transpose.h: one lane is its own transpose.

#include "energies/autodiff/pack.h"

#include <array>

namespace shellmatch::autodiff {

inline void transpose(std::array<Pack, pack_size>&) {}

}  // namespace shellmatch::autodiff
