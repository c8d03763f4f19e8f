#pragma once
/// \file
/// Sets of named points in the formats of other programs: control points of 3D Slicer (.fcsv, .mrk.json), landmarks for
/// morphometrics
/// (.tps as of Rohlf's tps programs, .txt as of Morphologika 2.5; geomorph reads both). Each names the frame of the
/// coordinates.

#include "geometry/surface/space.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace shellmatch {

enum class PointFormat { none, fcsv, markups, tps, morphologika };

/// By the ending of the file's name; none where it is that of no such format.
PointFormat point_format(const std::string& path);

/// The points of one individual; homologous points of several have the same place in each.
template <int Dim>
struct PointSet {
  std::string individual;                       ///< its id
  std::vector<std::string> names;               ///< of the points, one for each
  std::vector<std::optional<Vec<Dim>>> points;  ///< none where it is not known
};

/// The text of the file. \param space of the coordinates; may be unsaid but for Slicer's formats
/// \pre Slicer's formats have one individual in space
template <int Dim>
std::string point_sets_text(PointFormat format, const std::vector<PointSet<Dim>>& sets, Space space);

// The formats, for point_sets_text().
std::string markups_text(const PointSet<3>& set, Space space);

}  // namespace shellmatch
