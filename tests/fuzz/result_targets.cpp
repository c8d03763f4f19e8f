#include "apps/studies/execution/run_result.h"
#include "base/error.h"
#include "matching/checkpoint/alignment_file.h"
#include "matching/checkpoint/checkpoints.h"
#include "matching/checkpoint/level_vertices.h"
#include "matching/map_file/deformation_file.h"
#include "matching/output/checksum.h"
#include "matching/output/history_file.h"
#include "matching/output/summary.h"
#include "matching/output/written_files.h"
#include "matching/pairs/landmark_file.h"
#include "matching/pairs/point_formats.h"
#include "matching/pairs/slicer_points.h"
#include "matching/result/correspondence.h"
#include "tests/fuzz/memory_file.h"
#include "tests/fuzz/target.h"

#include <cmath>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace shellmatch::fuzz {

namespace {

template <int Dim>
void check_map(const std::string& path) {
  const Deformation<Dim> map = read_deformation<Dim>(path);
  demand(map.phi.size() == static_cast<std::size_t>(map.grid.n_nodes()), "a map has a value at each node");
  for (const Vec<Dim>& x : map.phi) demand(x.allFinite(), "a map is finite");
  demand(map.placement.scale > 0 && map.pose.scale > 0, "scales are positive");
}

template <int Dim>
void expect_other_dimension_refused(const std::string& path) {
  try {
    read_deformation<Dim>(path);
  } catch (const InputError&) {
    return;
  }
  demand(false, "a map has one dimension");
}

// A few vertices, to which files refer by number.
template <int Dim>
std::vector<Vec<Dim>> some_vertices() {
  return std::vector<Vec<Dim>>(9, Vec<Dim>::Constant(0.25));
}

template <int Dim>
void check_landmarks(const LandmarkOptions& options) {
  const std::vector<Vec<Dim>> vertices = some_vertices<Dim>();
  const auto landmarks = read_landmarks<Dim>(options, vertices, vertices);
  demand(!landmarks.empty(), "a file that is read has a landmark");
  for (const Landmark<Dim>& landmark : landmarks)
    demand(landmark.on_reference.allFinite() && landmark.on_template.allFinite() && std::isfinite(landmark.weight) &&
               landmark.weight > 0,
           "landmarks are finite, weights positive");
}

// Calls both, of which either may refuse the input of the other; the last refusal goes on.
template <class First, class Second>
void both(const First& first, const Second& second) {
  try {
    first();
  } catch (const InputError&) {
  }
  second();
}

}  // namespace

// Input without the line of the checksum gets one: of an input that was changed, no checksum would be right.
void read_map_file(std::string_view bytes) {
  const MemoryFile file(bytes);
  if (!bytes.ends_with(" -->\n")) append_checksum(file.path());
  if (deformation_dimension(file.path()) == 2) {
    expect_other_dimension_refused<3>(file.path());
    check_map<2>(file.path());
  } else {
    expect_other_dimension_refused<2>(file.path());
    check_map<3>(file.path());
  }
}

void read_history_file(std::string_view bytes) {
  const History history = read_history(MemoryFile(bytes).path());
  for (const bool over_seconds : {false, true})
    for (const Series& series : energy_plot(history, over_seconds).series)
      demand(series.x.size() == series.y.size(), "a curve has a value at each place");
  const MemoryFile written("");
  write_history(history, written.path());
  demand(history_csv(read_history(written.path())) == history_csv(history), "a history that is written is read back");
}

void read_summary_file(std::string_view bytes) {
  const MatchSummary summary = read_summary(MemoryFile(bytes).path());
  const MemoryFile written("");
  write_summary(summary, written.path());
  demand(summary_json(read_summary(written.path())) == summary_json(summary), "a summary that is written is read back");
}

// What read() finds in the file, and text_of() writes, is read back the same.
void demand_round_trip(std::string_view bytes, auto read, auto text_of, const char* what) {
  const auto found = read(MemoryFile(bytes).path());
  if (!found) return;
  const std::string text = text_of(*found);
  const auto again = read(MemoryFile(text).path());
  demand(again && text_of(*again) == text, what);
}

void read_manifest_file(std::string_view bytes) {
  demand_round_trip(bytes, read_manifest, manifest_json, "a manifest that is written is read back");
}

namespace {

template <int Dim>
void check_levels(std::string_view bytes) {
  const auto levels = read_level_vertices<Dim>(MemoryFile(bytes).path(), 2);
  for (const LevelVertices<Dim>& level : levels) {
    demand(level.level > 0 && level.vertices.size() == 2, "levels have the vertices of the run");
    for (const Vec<Dim>& x : level.vertices) demand(x.allFinite(), "vertices are finite");
  }
  const MemoryFile written("");
  write_level_vertices<Dim>(levels, written.path());
  std::ifstream in(written.path(), std::ios::binary);
  demand(std::string(std::istreambuf_iterator<char>(in), {}) == bytes, "levels that are written are read back");
}

}  // namespace

// Of a reference of two vertices, in the plane and in space.
void read_kept_levels(std::string_view bytes) {
  both([&] { check_levels<2>(bytes); }, [&] { check_levels<3>(bytes); });
}

namespace {

std::string contents_of(const MemoryFile& file) {
  std::ifstream in(file.path(), std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

template <int Dim>
void check_alignment(std::string_view bytes) {
  const AlignmentFindings<Dim> findings = read_alignment<Dim>(MemoryFile(bytes).path());
  const MemoryFile once(""), twice("");
  write_alignment(findings, once.path());
  write_alignment(read_alignment<Dim>(once.path()), twice.path());
  demand(contents_of(once) == contents_of(twice), "an alignment that is written is read back");
}

}  // namespace

void read_kept_alignment(std::string_view bytes) {
  both([&] { check_alignment<2>(bytes); }, [&] { check_alignment<3>(bytes); });
}

void read_list_of_files(std::string_view bytes) {
  demand_round_trip(bytes, parse_file_list, file_list_json, "a list of files that is written is read back");
}

void read_result_of_run(std::string_view bytes) {
  const auto result = read_run_result(MemoryFile(bytes).path());
  if (!result) return;
  const MemoryFile written("");
  write_run_result(*result, written.path());
  const auto again = read_run_result(written.path());
  demand(again && again->status == result->status && again->peak_memory_bytes == result->peak_memory_bytes &&
             again->exit_code == result->exit_code,
         "a result that is written is read back");
}

namespace {

// CSV, or what files of 3D Slicer's and of TPS begin with.
std::string_view ending_of_landmarks(std::string_view bytes) {
  return bytes.starts_with("# Markups") ? ".fcsv"
         : bytes.starts_with("{")       ? ".mrk.json"
         : bytes.starts_with("LM")      ? ".tps"
                                        : ".csv";
}

}  // namespace

// One part is one file with both shapes, of two parts each has a shape, a third one takes the first file away, a fourth
// one leaves out what one of them lacks. Both dimensions see them.
void read_landmark_files(std::string_view bytes) {
  const auto parts = parts_of(bytes, separator);
  const std::string_view second = parts.size() > 1 ? parts[1] : "";
  const NamedMemoryFile file(parts[0], ending_of_landmarks(parts[0])), other(second, ending_of_landmarks(second));
  LandmarkOptions options;
  options.file = parts.size() == 3 ? "" : file.path();
  if (parts.size() > 1) options.template_file = other.path();
  if (parts.size() > 3) options.unpaired = UnpairedLandmarks::are_left_out;
  both([&] { check_landmarks<2>(options); }, [&] { check_landmarks<3>(options); });
}

namespace {

// Points that are put back where they were are read again where they were.
void check_slicer_points(SlicerPoints file, auto parse) {
  file.points = parse(file.path, file.text);
  demand(slicer_points_json(file).ends_with("\n"), "points are told as JSON");
  std::vector<Vec<3>> positions;
  for (const SlicerPoint& p : file.points) {
    demand(p.position.allFinite() && p.space != Space::unsaid, "control points are finite, in a frame");
    positions.push_back(p.position);
  }
  const std::vector<SlicerPoint> again = parse(file.path, with_positions(file, positions));
  demand(again.size() == file.points.size(), "a file of control points that is written is read back");
  for (std::size_t i = 0; i < again.size(); ++i)
    demand(again[i].position == positions[i] && again[i].name == file.points[i].name &&
               again[i].space == file.points[i].space,
           "control points go out as they came in");
  if (file.points.empty()) return;
  // Written anew, in one frame.
  PointSet<3> set{"input", {}, {}};
  for (const SlicerPoint& p : file.points) {
    set.names.push_back(p.name);
    set.points.push_back(p.has_position ? std::optional(in_space(p.position, p.space, Space::ras)) : std::nullopt);
  }
  for (const bool is_json : {false, true}) {
    const std::string text = point_sets_text<3>(is_json ? PointFormat::markups : PointFormat::fcsv, {set}, Space::ras);
    const std::vector<SlicerPoint> anew = is_json ? parse_markups("a.mrk.json", text) : parse_fcsv("a.fcsv", text);
    demand(anew.size() == set.points.size(), "points that are written anew are read back");
    for (std::size_t i = 0; i < anew.size(); ++i)
      demand(
          anew[i].has_position == set.points[i].has_value() && (!set.points[i] || anew[i].position == *set.points[i]),
          "they are where they were");
  }
}

}  // namespace

void read_fcsv_file(std::string_view bytes) { check_slicer_points({"input.fcsv", std::string(bytes), {}}, parse_fcsv); }
void read_markups_file(std::string_view bytes) {
  check_slicer_points({"input.mrk.json", std::string(bytes), {}}, parse_markups);
}

void read_correspondence_file(std::string_view bytes) {
  const MemoryFile file(bytes);
  const auto check = [](const auto& list) {
    demand(!list.empty(), "a file that is read has a correspondence");
    for (const auto& [index, x] : list)
      demand(index >= 0 && index < 9 && x.allFinite(), "a correspondence is of a vertex");
    const std::vector vertices(9, list.front().second);
    demand(correspondence_error({list.front()}, vertices) == 0, "a vertex where it belongs has no error");
  };
  both([&] { check(read_correspondence<2>(file.path(), 9)); }, [&] { check(read_correspondence<3>(file.path(), 9)); });
}

}  // namespace shellmatch::fuzz
