#pragma once
/// \file
/// Outlines from the files of drawing and annotation programs: the areas of a file by their names, and a shape out of
/// them.

#include "geometry/outline/drawn_path.h"
#include "geometry/surface/surface.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace shellmatch {

inline constexpr std::size_t no_group = static_cast<std::size_t>(-1);

/// What is around areas: a class, a layer.
struct DrawnGroup {
  std::vector<std::string> names;
  std::size_t parent = no_group;
};

/// An area.
struct DrawnArea {
  std::vector<std::string> names;  ///< by which it can be chosen
  std::size_t group = no_group;
  std::vector<DrawnPath> paths;
  /// Where paths lie in each other an area is filled by the number of turns around a point ('nonzero'), else by their
  /// parity.
  bool is_filled_by_turns = false;
};

/// The areas of a file, as it has them.
struct Drawing {
  std::vector<DrawnArea> areas;
  std::vector<DrawnGroup> groups;
  bool is_downward = false;  ///< y counts down the rows of a picture or a page
  double scale = 1;          ///< coordinates are multiplied by it
  std::string unit = {};     ///< of coordinates then, where it is known
  std::vector<std::string> notes = {};
};

/// A shape out of a drawing.
struct DrawnOutline {
  OriginalShape<2> shape;
  std::vector<std::string> notes;
  std::string unit;
  std::string choices;  ///< where several areas were taken together, some of their names
};

/// Curves are flattened to that many diagonals of what is taken.
inline constexpr double curve_tolerance = 1e-4;

/// Depth of groups within groups that is followed.
inline constexpr int deepest_group = 100;

/// The areas that are named `part`, else those in groups of that name, or all where `part` is empty: their paths as
/// rings, y upward. \param source the whole name, for messages \throws InputError where there are none
DrawnOutline outline_of_drawing(Drawing drawing, const std::string& source, const std::string& part);

/// Up to ten names for a message: "'a', 'b', ...".
std::string some_names(const std::vector<std::string>& names);

/// tpsDig's and other morphometric files: the curves and outlines of the specimen of that ID.
Drawing read_tps_outline(const std::string& path, std::string_view bytes, const std::string& part);
/// A region of interest of ImageJ, .roi.
Drawing read_roi(const std::string& path, std::string_view bytes);
/// Several in a ZIP archive, as ImageJ's ROI Manager saves them.
Drawing read_roi_set(const std::string& path, std::string_view bytes);
/// GeoJSON (RFC 7946), of QuPath or of geographic programs.
Drawing read_geojson(const std::string& path, std::string_view bytes);
/// SVG 1.1 and 2.
Drawing read_svg(const std::string& path, std::string_view bytes);

}  // namespace shellmatch
