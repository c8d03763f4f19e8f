#pragma once
/// \file
/// A pair of shapes placed as an earlier matching has placed nearly the same ones.

#include "matching/alignment/prepare_pair.h"

#include <optional>

namespace shellmatch {

/// Moves both surfaces into the unit domain by an earlier frame, in its direction. None, and nothing is
/// moved, where they would not lie in it with `clearance` around them, are in another anatomical frame, or where the
/// frame bends another surface than the one that is moved.
/// \param shapes as prepare_pair()
template <int Dim>
std::optional<PreparedPair<Dim>> prepare_as_before(ShapePair<Dim>& shapes, const MapFrame<Dim>& frame,
                                                   double clearance);

}  // namespace shellmatch
