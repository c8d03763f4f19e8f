#include "apps/cohorts/subjects/mirrored.h"

#include "base/error.h"
#include "apps/cohorts/subjects/point_file.h"
#include "geometry/io/write_shape.h"
#include "matching/input/shape_source.h"
#include "matching/pairs/landmark_file.h"
#include "matching/pairs/point_frame.h"

#include <algorithm>
#include <filesystem>

namespace shellmatch {

namespace {

template <int Dim>
std::string write_mirrored(const Shape<Dim>& shape, const std::string& path) {
  OriginalShape<Dim> mirrored = shape.original;
  for (Vec<Dim>& x : mirrored.vertices) x[0] = -x[0];
  // Facets keep their outer side.
  for (std::vector<Index>& polygon : mirrored.polygons) std::ranges::reverse(polygon);
  if constexpr (Dim == 3) {
    write_ply(path + ".ply", mirrored);
    return path + ".ply";
  } else {
    write_outline_csv(path + ".csv", mirrored);
    return path + ".csv";
  }
}

}  // namespace

Space volume_space(const InputOptions& input) { return or_default(wanted_space(input)); }

std::string mirrored_shape(const Subject& subject, const InputOptions& input, const std::string& folder) {
  try {
    const AnyShape shape = open_shape(subject.source, input.close, volume_space(input));
    std::filesystem::create_directories(folder);
    return std::visit([&](const auto& s) { return write_mirrored(s, folder + "/" + subject.id); }, shape);
  } catch (const InputError&) {
    return subject.source;
  }
}

std::string mirrored_landmarks(const Subject& subject, const InputOptions& input, const std::string& folder) {
  const std::string path = folder + "/" + subject.id + "_landmarks.csv";
  try {
    const AnyShape shape = open_shape(subject.source, input.close, volume_space(input));
    std::filesystem::create_directories(folder);
    std::visit(
        [&]<int Dim>(const Shape<Dim>& s) {
          std::vector<std::string> notes;
          const Space space = space_beside(s.original, subject.landmarks, wanted_space(input));
          std::vector<NamedPoint<Dim>> points = read_named_points<Dim>(subject.landmarks, s.original.vertices, space,
                                                                       space, notes, nullptr, s.original.frame);
          for (NamedPoint<Dim>& point : points) point.point[0] = -point.point[0];
          write_named_points(path, points);
        },
        shape);
    return path;
  } catch (const InputError&) {
    return subject.landmarks;
  }
}

}  // namespace shellmatch
