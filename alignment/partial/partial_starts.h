#pragma once
/// \file
/// First guesses of a map from a part to a whole, by the distances of few samples of the part.

#include <Eigen/Core>

#include "alignment/partial/partial_map.h"

#include <vector>

namespace shellmatch {

/// Starts and maps that differ by less at nearly all points, in roots of the whole's area, are one: those with one
/// wrong limb are cheap, too.
inline constexpr double same_map = 0.2, nearly_all = 0.9;

/// Samples of a whole, where those of a part may lie.
struct Places {
  std::vector<Index> vertices;
  Eigen::MatrixXf distances;  ///< n_vertices x places, along edges
  std::vector<int> nearest;   ///< of each vertex
};

Places places_on(const PartialShape& whole);

struct PartialStarts {
  std::vector<Index> queries;              ///< vertices of the part, well spread
  std::vector<std::vector<Index>> images;  ///< of the queries on the whole, for each start, the best first
};

/// The last start is the surfaces as they lie. \pre `places` are those of the whole
PartialStarts partial_starts(const PartialShape& part, const PartialShape& whole, const Places& places);

/// The vertex nearest to a point.
Index nearest_vertex(const Surface<3>& surface, const Vec<3>& x);

}  // namespace shellmatch
