#pragma once
/// \file
/// Control points of 3D Slicer's markups, .fcsv and .mrk.json
/// (https://slicer.readthedocs.io/en/latest/developer_guide/modules/markups.html). A file goes out as it came in, but
/// for the positions.

#include "geometry/surface/space.h"

#include <string>
#include <vector>

namespace shellmatch {

/// A control point as it stands in a file.
struct SlicerPoint {
  std::string name;                  ///< its label; may be empty
  Vec<3> position = Vec<3>::Zero();  ///< in `space`, finite
  Space space = Space::unsaid;       ///< ras or lps
  bool has_position = true;          ///< false of a point that is listed but not placed yet, or missing
  std::string place;                 ///< "points.fcsv, line 4", for messages
};

struct SlicerPoints {
  std::string path, text;           ///< the file and its contents
  std::vector<SlicerPoint> points;  ///< in the order of the file
};

/// Whether the name ends in .fcsv or .mrk.json, in letters of either case.
bool is_slicer_file(const std::string& path);

/// \throws InputError that names the file and the line or the control point
SlicerPoints read_slicer_points(const std::string& path);

/// The text of the file with the positions, in the frame of each point, of all points that have one; everything else as
/// it was: names, descriptions, the frame. \pre one position for each point
std::string with_positions(const SlicerPoints& file, const std::vector<Vec<3>>& positions);

/// One line that says which positions the frame of the shapes has otherwise; empty where there are none.
std::string space_note(const SlicerPoints& file, Space shapes);

/// What is in the file, in words and as a JSON object: how many points, how many of them without position, and their
/// frames.
std::string slicer_points_text(const SlicerPoints& file);
std::string slicer_points_json(const SlicerPoints& file);

// The two formats, for read_slicer_points() and with_positions().
std::vector<SlicerPoint> parse_fcsv(const std::string& path, const std::string& text);
std::string fcsv_with_positions(const SlicerPoints& file, const std::vector<Vec<3>>& positions);
std::vector<SlicerPoint> parse_markups(const std::string& path, const std::string& text);
std::string markups_with_positions(const SlicerPoints& file, const std::vector<Vec<3>>& positions);

}  // namespace shellmatch
