#include "matching/pairs/point_formats.h"

#include "base/error.h"
#include "base/text.h"
#include "geometry/io/input_file.h"
#include "geometry/outline/tps_file.h"
#include "matching/pairs/slicer_points.h"

#include <fmt/format.h>

#include <iterator>
#include <limits>

namespace shellmatch {

namespace {

// On one line, as these formats have no quotes.
std::string on_a_line(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20) c = ' ';
  return text;
}

template <int Dim>
void append_coordinates(std::string& text, const std::optional<Vec<Dim>>& x, std::string_view separator) {
  for (int k = 0; k < Dim; ++k) {
    if (k > 0) text += separator;
    if (x) fmt::format_to(std::back_inserter(text), "{}", (*x)[k]);
    else text += "NA";
  }
  text.push_back('\n');
}

// The last field of the position's status and that of points placed by the program, as Slicer 5 writes them.
std::string fcsv_text(const PointSet<3>& set, Space space) {
  std::string text = fmt::format(
      "# Markups fiducial file version = 5.0\n# CoordinateSystem = {}\n"
      "# columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID\n",
      space_name(space));
  for (std::size_t i = 0; i < set.points.size(); ++i) {
    const Vec<3> x = set.points[i].value_or(Vec<3>::Zero());
    text += fmt::format("{},{},{},{},0,0,0,1,1,1,0,{},,,{},0\n", i + 1, x.x(), x.y(), x.z(),
                        csv_field(on_a_line(set.names[i])), set.points[i] ? 2 : 3);
  }
  return text;
}

template <int Dim>
std::string tps_text(const std::vector<PointSet<Dim>>& sets, Space space) {
  std::string text;
  for (const PointSet<Dim>& set : sets) {
    std::vector<double> coordinates;
    for (const auto& x : set.points)
      for (int k = 0; k < Dim; ++k) coordinates.push_back(x ? (*x)[k] : std::numeric_limits<double>::quiet_NaN());
    append_tps_specimen(text, set.individual, coordinates, Dim, space);
  }
  return text;
}

// The frame is a label of each individual, as the format has no comments.
template <int Dim>
std::string morphologika_text(const std::vector<PointSet<Dim>>& sets, Space space) {
  std::string text = fmt::format("[individuals]\n{}\n[landmarks]\n{}\n[dimensions]\n{}\n[names]\n", sets.size(),
                                 sets.empty() ? 0 : sets.front().points.size(), Dim);
  for (const PointSet<Dim>& set : sets) text += on_a_line(set.individual) + "\n";
  if (space != Space::unsaid) {
    text += "[labels]\nSPACE\n[labelvalues]\n";
    for (std::size_t i = 0; i < sets.size(); ++i) text += fmt::format("{}\n", space_name(space));
  }
  text += "[rawpoints]\n";
  for (const PointSet<Dim>& set : sets) {
    text += fmt::format("'{}\n", on_a_line(set.individual));
    for (const auto& x : set.points) append_coordinates<Dim>(text, x, " ");
  }
  return text;
}

}  // namespace

PointFormat point_format(const std::string& path) {
  if (is_slicer_file(path)) return file_extension(path) == ".json" ? PointFormat::markups : PointFormat::fcsv;
  const std::string ending = file_extension(path);
  return ending == ".tps" ? PointFormat::tps : ending == ".txt" ? PointFormat::morphologika : PointFormat::none;
}

template <int Dim>
std::string point_sets_text(PointFormat format, const std::vector<PointSet<Dim>>& sets, Space space) {
  for (const PointSet<Dim>& set : sets)
    SHELLMATCH_CHECK(set.names.size() == set.points.size(), "each point has a name");
  if constexpr (Dim == 3) {
    SHELLMATCH_CHECK(
        (format != PointFormat::fcsv && format != PointFormat::markups) || (sets.size() == 1 && space != Space::unsaid),
        "files of 3D Slicer hold one set of points, in a frame");
    if (format == PointFormat::fcsv) return fcsv_text(sets.front(), space);
    if (format == PointFormat::markups) return markups_text(sets.front(), space);
  }
  if (format == PointFormat::tps) return tps_text(sets, space);
  SHELLMATCH_CHECK(format == PointFormat::morphologika, "points of the plane are written as TPS or for Morphologika");
  return morphologika_text(sets, space);
}

SHELLMATCH_2D_3D(point_sets_text);

}  // namespace shellmatch
