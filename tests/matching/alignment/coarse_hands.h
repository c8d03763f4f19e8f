#pragma once
/// \file
/// A hand and a bent one of edges that suit levels up to 5: half the vertices of those that users see.

#include "geometry/generate/generate_shape.h"
#include "geometry/repair/make_shape.h"
#include "matching/input/shape_pair.h"
#include "matching/result/correspondence.h"

#include <variant>

namespace shellmatch::testing {

inline const GeneratedPair<3>& generated_coarse_hands() {
  static const auto pair = std::get<GeneratedPair<3>>(generated_pair("hand", 0.015));
  return pair;
}

inline ShapePair<3> coarse_hands() {
  const GeneratedPair<3>& pair = generated_coarse_hands();
  return {make_shape(pair.reference, "hand"), make_shape(pair.template_shape, "bent hand")};
}

/// Of the vertices that move rigidly.
inline Correspondence<3> truth_of_coarse_hands() {
  Correspondence<3> truth;
  for (const KnownPosition<3>& known : generated_coarse_hands().truth) truth.emplace_back(known.vertex, known.position);
  return truth;
}

}  // namespace shellmatch::testing
