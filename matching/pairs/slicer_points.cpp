#include "matching/pairs/slicer_points.h"

#include "base/error.h"
#include "base/printable.h"
#include "base/text.h"
#include "geometry/io/input_file.h"
#include "geometry/mesh_text/read_text.h"

#include <fmt/ranges.h>

#include <algorithm>

namespace shellmatch {

namespace {

bool ends_in(const std::string& path, std::string_view ending) {
  return path.size() > ending.size() &&
         equals_ignoring_case(std::string_view(path).substr(path.size() - ending.size()), ending);
}

bool is_fcsv(const std::string& path) { return ends_in(path, ".fcsv"); }

}  // namespace

bool is_slicer_file(const std::string& path) { return is_fcsv(path) || ends_in(path, ".mrk.json"); }

SlicerPoints read_slicer_points(const std::string& path) {
  SlicerPoints file{path, InputFile(path).read(), {}};
  file.points = is_fcsv(path) ? parse_fcsv(path, file.text) : parse_markups(path, file.text);
  if (file.points.empty()) throw_input_error("{}: holds no control points", path);
  return file;
}

std::string with_positions(const SlicerPoints& file, const std::vector<Vec<3>>& positions) {
  SHELLMATCH_CHECK(positions.size() == file.points.size(), "each control point has a position");
  return is_fcsv(file.path) ? fcsv_with_positions(file, positions) : markups_with_positions(file, positions);
}

std::string space_note(const SlicerPoints& file, Space shapes) {
  const auto other = [&](const SlicerPoint& p) { return p.has_position && p.space != shapes; };
  const auto first = std::ranges::find_if(file.points, other);
  if (first == file.points.end()) return "";
  const auto n = static_cast<std::size_t>(std::ranges::count_if(file.points, other));
  return fmt::format("{}: {} from {} to {}, the frame of the shapes: x and y change their sign", file.path,
                     counted(n, "point", "points"), space_name(first->space), space_name(shapes));
}

namespace {

std::string spaces_of(const SlicerPoints& file) {
  std::vector<std::string_view> names;
  for (const SlicerPoint& p : file.points)
    if (std::ranges::find(names, space_name(p.space)) == names.end()) names.push_back(space_name(p.space));
  return fmt::format("{}", fmt::join(names, ", "));
}

std::size_t n_without_position(const SlicerPoints& file) {
  return static_cast<std::size_t>(std::ranges::count(file.points, false, &SlicerPoint::has_position));
}

}  // namespace

std::string slicer_points_text(const SlicerPoints& file) {
  return fmt::format("{}: points of 3D Slicer\n  {:<22}{}, of which {} without position\n  {:<22}{}\n",
                     printable(file.path, max_message_length), "in the file",
                     counted(file.points.size(), "point", "points"), n_without_position(file), "frame",
                     spaces_of(file));
}
}  // namespace shellmatch
