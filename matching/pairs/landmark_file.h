#pragma once
/// \file
/// Landmarks from CSV files, from 3D Slicer's markups and from TPS files (docs/landmarks.md).

#include "geometry/surface/plane_frame.h"
#include "geometry/surface/space.h"
#include "matching/pairs/landmarks.h"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace shellmatch {

/// The frames of the coordinates of shapes, unsaid where they name none; in the plane what became of those in their
/// files.
struct LandmarkSpaces {
  Space reference_file = Space::unsaid;  ///< of the reference as it stands in its file
  Space shapes = Space::unsaid;          ///< of both shapes as they are matched
  PlaneFrame reference_frame = {}, template_frame = {};
};

/// Reads the landmarks that the options name: one file with columns `x1,y1[,z1]` or `vertex1` and `x2,y2[,z2]` or
/// `vertex2`, or two files with columns `name` and `x,y[,z]` or `vertex` each; a column `weight` or `sd` of the first
/// file weighs them, and `name` names them. Either of two files may be one of 3D Slicer's
/// (matching/pairs/slicer_points.h); its points are converted to the frame of the shapes; or one of TPS
/// (geometry/outline/tps_file.h), "points.tps:ID", whose points are named by their numbers from 1. A point that either
/// file lists without a position is left out. None where the options name no file. \param reference, template_shape
/// vertices in the order of the shapes' files, to which indices from 0 refer \param notes takes a line for each file
/// that was converted or has points without position \throws InputError with file and line
template <int Dim>
std::vector<Landmark<Dim>> read_landmarks(const LandmarkOptions& options, const std::vector<Vec<Dim>>& reference,
                                          const std::vector<Vec<Dim>>& template_shape,
                                          const LandmarkSpaces& spaces = {}, std::vector<std::string>* notes = nullptr);

/// A landmark on one shape.
template <int Dim>
struct NamedPoint {
  std::string name;
  Vec<Dim> point;
  std::string place;  ///< where it was read, "points.csv, line 3"
  std::optional<double> weight = {}, deviation = {};
};

/// Reads a file that holds the points of one shape, as either of two above; names are distinct.
/// \param vertices to which indices refer \param file_space of coordinates whose file names no frame
/// \param shapes the frame of the result \param frame in the plane, of the shape to which coordinates of CSV belong
/// \param unplaced takes the names of points that the file lists without a position, which are left out \throws
/// InputError with file and line
template <int Dim>
std::vector<NamedPoint<Dim>> read_named_points(const std::string& path, const std::vector<Vec<Dim>>& vertices,
                                               Space file_space, Space shapes, std::vector<std::string>& notes,
                                               std::set<std::string>* unplaced = nullptr, const PlaneFrame& frame = {});

}  // namespace shellmatch
