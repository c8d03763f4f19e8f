#include "matching/pairs/landmark_file.h"

#include "base/error.h"
#include "base/text.h"
#include "geometry/io/input_file.h"
#include "geometry/outline/tps_file.h"
#include "matching/pairs/landmark_rows.h"
#include "matching/pairs/slicer_points.h"

#include <algorithm>
#include <map>
#include <optional>

namespace shellmatch {

namespace {

void note_left_out(const std::string& path, std::size_t n, std::vector<std::string>& notes) {
  if (n > 0) notes.push_back(fmt::format("{}: {} without position left out", path, counted(n, "point", "points")));
}

std::vector<NamedPoint<3>> slicer_landmarks(const std::string& path, Space shapes, std::vector<std::string>& notes,
                                            std::set<std::string>& unplaced) {
  const SlicerPoints file = read_slicer_points(path);
  std::vector<NamedPoint<3>> points;
  std::map<std::string, std::string> place_of;
  for (const SlicerPoint& point : file.points) {
    if (!point.has_position) {
      unplaced.insert(point.name);
      continue;
    }
    if (point.name.empty())
      throw_input_error("{}: the label is empty, by which points of two files belong together", point.place);
    if (const auto [at, is_new] = place_of.emplace(point.name, point.place); !is_new)
      throw_input_error("{}: the name '{}' stands in {} already", point.place, point.name, at->second);
    points.push_back({point.name, in_space(point.position, point.space, or_default(shapes)), point.place});
  }
  if (points.empty()) throw_input_error("{}: none of its control points has a position", path);
  note_left_out(path, file.points.size() - points.size(), notes);
  if (std::string note = space_note(file, or_default(shapes)); !note.empty()) notes.push_back(std::move(note));
  return points;
}

bool is_tps(const std::string& path) { return format_of(split_part(path).file) == FileFormat::tps; }

// In y upward and the file's own scale, whatever the shape's file has.
template <int Dim>
std::vector<NamedPoint<Dim>> tps_landmarks(const std::string& path, Space file_space, Space shapes,
                                           std::vector<std::string>& notes, std::set<std::string>& unplaced) {
  const PartName name = split_part(path);
  const std::vector<TpsSpecimen> specimens = parse_tps(name.file, InputFile(name.file).read());
  const TpsSpecimen& specimen = chosen_specimen(specimens, name.file, name.part);
  const std::vector<std::optional<Vec<Dim>>> positions = scaled_landmarks<Dim>(specimen, path);
  std::vector<NamedPoint<Dim>> points;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const std::string number = fmt::format("{}", i + 1);
    if (!positions[i]) {
      unplaced.insert(number);
      continue;
    }
    Vec<Dim> x = *positions[i];
    if constexpr (Dim == 3) x = in_space(x, specimen.space == Space::unsaid ? file_space : specimen.space, shapes);
    points.push_back({number, x, fmt::format("{}, landmark {}", path, number)});
  }
  if (points.empty()) throw_input_error("{}: none of its points has a position", path);
  note_left_out(path, positions.size() - points.size(), notes);
  if (const std::string note = scale_note(specimens, specimen); !note.empty())
    notes.push_back(fmt::format("{}: {}", path, note));
  return points;
}

}  // namespace

template <int Dim>
std::vector<NamedPoint<Dim>> read_named_points(const std::string& path, const std::vector<Vec<Dim>>& vertices,
                                               Space file_space, Space shapes, std::vector<std::string>& notes,
                                               std::set<std::string>* unplaced, const PlaneFrame& frame) {
  std::set<std::string> none;
  std::set<std::string>& without = unplaced ? *unplaced : none;
  if (is_slicer_file(path)) {
    if constexpr (Dim == 3) return slicer_landmarks(path, shapes, notes, without);
    else throw_input_error("{}: holds points of space, but the shapes are of the plane; give a CSV file", path);
  }
  if (is_tps(path)) return tps_landmarks<Dim>(path, file_space, shapes, notes, without);
  std::vector<NamedPoint<Dim>> points;
  for_each_landmark_row<Dim>(path, {""}, true, [&](const LandmarkRow& row, const std::string& name) {
    if (row.is_missing<Dim>("")) {
      without.insert(name);
      return;
    }
    NamedPoint<Dim> point{name, row.point<Dim>("", vertices, file_space, shapes, frame), row.place()};
    if (row.find("sd")) point.deviation = row.positive("sd");
    if (row.find("weight")) point.weight = row.positive("weight");
    points.push_back(std::move(point));
  });
  if (points.empty()) throw_input_error("{}: none of its points has a position", path);
  note_left_out(path, without.size(), notes);
  return points;
}

namespace {

/// Landmarks, and their standard deviations where the file has these instead of weights.
template <int Dim>
struct FileLandmarks {
  std::vector<Landmark<Dim>> landmarks;
  std::map<std::string, double> deviations = {};  ///< by name: of all, or of none
};

/// The landmarks of a file that holds the points of both shapes.
template <int Dim>
FileLandmarks<Dim> landmarks_of_both(const std::string& path, const std::vector<Vec<Dim>>& reference,
                                     const std::vector<Vec<Dim>>& template_shape, const LandmarkSpaces& spaces) {
  if (is_slicer_file(path) || is_tps(path))
    throw_input_error("{}: holds points of one shape; give those of the template, too (--template-landmarks)", path);
  FileLandmarks<Dim> read;
  for_each_landmark_row<Dim>(path, {"1", "2"}, false, [&](const LandmarkRow& row, const std::string& name) {
    Landmark<Dim> landmark{name,
                           row.point<Dim>("1", reference, spaces.reference_file, spaces.shapes, spaces.reference_frame),
                           row.point<Dim>("2", template_shape, spaces.shapes, spaces.shapes, spaces.template_frame)};
    if (row.find("sd")) read.deviations[name] = row.positive("sd");
    if (row.find("weight")) landmark.weight = row.positive("weight");
    landmark.reference_origin = landmark.template_origin = row.place();
    read.landmarks.push_back(std::move(landmark));
  });
  return read;
}

/// The landmarks of two files, which belong together by name.
template <int Dim>
FileLandmarks<Dim> landmarks_of_each(const LandmarkOptions& options, const std::vector<Vec<Dim>>& reference,
                                     const std::vector<Vec<Dim>>& template_shape, const LandmarkSpaces& spaces,
                                     std::vector<std::string>& notes) {
  std::map<std::string, Landmark<Dim>*> landmark_of;
  std::set<std::string> unplaced_here, unplaced_there;
  const std::vector<NamedPoint<Dim>> here = read_named_points<Dim>(
      options.file, reference, spaces.reference_file, spaces.shapes, notes, &unplaced_here, spaces.reference_frame);
  FileLandmarks<Dim> read;
  std::vector<Landmark<Dim>>& landmarks = read.landmarks;
  landmarks.reserve(here.size());  // the map keeps addresses
  for (const NamedPoint<Dim>& point : here) {
    if (point.deviation) read.deviations[point.name] = *point.deviation;
    landmarks.push_back({point.name, point.point, {}, point.weight.value_or(1), point.place, {}});
    landmark_of[point.name] = &landmarks.back();
  }
  for (const NamedPoint<Dim>& point :
       read_named_points<Dim>(options.template_file, template_shape, spaces.shapes, spaces.shapes, notes,
                              &unplaced_there, spaces.template_frame)) {
    const auto at = landmark_of.find(point.name);
    if (at == landmark_of.end()) {
      if (unplaced_here.contains(point.name) || options.unpaired == UnpairedLandmarks::are_left_out) continue;
      throw_input_error("{}: the name '{}' is unknown to {}", point.place, point.name, options.file);
    }
    if (point.weight || point.deviation) throw_input_error("{}: weights stand in {}", point.place, options.file);
    at->second->on_template = point.point;
    at->second->template_origin = point.place;
  }
  const auto is_unpaired = [](const Landmark<Dim>& landmark) { return landmark.template_origin.empty(); };
  std::erase_if(landmarks, [&](const Landmark<Dim>& landmark) {
    return is_unpaired(landmark) &&
           (options.unpaired == UnpairedLandmarks::are_left_out || unplaced_there.contains(landmark.name));
  });
  for (const Landmark<Dim>& landmark : landmarks)
    if (is_unpaired(landmark))
      throw_input_error("{}: the name '{}' is unknown to {}", landmark.reference_origin, landmark.name,
                        options.template_file);
  if (landmarks.empty())
    throw_input_error("{}: has no name in common with {}; leave the landmarks out, or name them alike",
                      options.template_file, options.file);
  return read;
}

/// Standard deviations become weights 1 / sd^2, scaled to a mean of 1.
template <int Dim>
std::vector<Landmark<Dim>> weighted(FileLandmarks<Dim> read) {
  if (read.deviations.empty()) return std::move(read.landmarks);
  double sum = 0;
  for (Landmark<Dim>& landmark : read.landmarks) {
    const double deviation = read.deviations.at(landmark.name);
    sum += landmark.weight = 1 / (deviation * deviation);
  }
  for (Landmark<Dim>& landmark : read.landmarks) landmark.weight *= static_cast<double>(read.landmarks.size()) / sum;
  return std::move(read.landmarks);
}

}  // namespace

template <int Dim>
std::vector<Landmark<Dim>> read_landmarks(const LandmarkOptions& options, const std::vector<Vec<Dim>>& reference,
                                          const std::vector<Vec<Dim>>& template_shape, const LandmarkSpaces& spaces,
                                          std::vector<std::string>* notes) {
  if (options.file.empty()) {
    if (!options.template_file.empty())
      throw_input_error("landmarks.template_file: {}: landmarks.file, the points of the reference, is missing",
                        options.template_file);
    return {};
  }
  std::vector<std::string> own_notes;
  return weighted(options.template_file.empty()
                      ? landmarks_of_both<Dim>(options.file, reference, template_shape, spaces)
                      : landmarks_of_each<Dim>(options, reference, template_shape, spaces, notes ? *notes : own_notes));
}

SHELLMATCH_2D_3D(read_landmarks);
SHELLMATCH_2D_3D(read_named_points);

}  // namespace shellmatch
