#pragma once
/// \file
/// Lines of a CSV file of landmarks.

#include "base/types.h"
#include "geometry/mesh_text/read_text.h"
#include "geometry/surface/plane_frame.h"
#include "geometry/surface/space.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace shellmatch {

/// A line of a file with the column names of its head line. All functions throw InputError with file and line.
class LandmarkRow {
 public:
  LandmarkRow(const LineReader& reader, const std::vector<std::string>& columns, std::vector<std::string> fields);

  const std::string* find(std::string_view column) const;
  /// Finite. \pre the column exists
  double number(std::string_view column) const;
  /// From 1e-50 to 1e50, so that the square of a ratio of two neither overflows nor vanishes. \pre the column exists
  double positive(std::string_view column) const;
  /// The point of the columns vertexS or xS, yS (and zS) for a suffix S. Coordinates are converted from one frame to
  /// the other, or, in the plane, as those of the shape's file were.
  template <int Dim>
  Vec<Dim> point(const std::string& suffix, const std::vector<Vec<Dim>>& vertices, Space from, Space to,
                 const PlaneFrame& frame) const;
  /// Whether the file lists the point without a position: all coordinates are empty, NA or nan.
  template <int Dim>
  bool is_missing(const std::string& suffix) const;
  std::string place() const;  ///< "points.csv, line 3"

 private:
  const LineReader& reader_;
  const std::vector<std::string>& columns_;
  std::vector<std::string> fields_;
};

/// Calls body(row, name) for every line; names are distinct.
/// \param suffixes of the columns of points: one of each shape
/// \throws InputError also for a head line with columns that are unknown, doubled or lacking
template <int Dim>
void for_each_landmark_row(const std::string& path, const std::vector<std::string>& suffixes, bool names_needed,
                           const std::function<void(const LandmarkRow&, const std::string& name)>& body);

}  // namespace shellmatch
