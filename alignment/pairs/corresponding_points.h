#pragma once
/// \file
/// Two points that correspond.

#include "base/types.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace shellmatch {

template <int Dim>
struct CorrespondingPointsIn {
  Vec<Dim> on_reference, on_template;  ///< in the coordinates of the input
  double weight = 1;                   ///< confidence, greater than 0, at most 1
};

using CorrespondingPoints = CorrespondingPointsIn<3>;

/// Median distance from map(on_reference) to on_template, weights left out. \pre there are pairs
template <int Dim>
double median_distance(const std::vector<CorrespondingPointsIn<Dim>>& pairs, const auto& map) {
  std::vector<double> distances;
  for (const auto& pair : pairs) distances.push_back((map(pair.on_reference) - pair.on_template).norm());
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return *middle;
}

}  // namespace shellmatch
