#include "cohorts/output/own_files.h"

#include "base/error.h"
#include "cohorts/cohort.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <vector>

namespace shellmatch {

namespace fs = std::filesystem;

namespace {

constexpr std::array statistics_files{"mean.ply", "mean.csv", "mean.vtp", "modes.npy", "modes.csv", "scores.csv"};
constexpr std::array point_files{"points.npy", "aligned.npy", "faces.npy"};

/// mode_K_minus.ply, mode_K_plus.csv, mode_K.webp
bool is_of_a_mode(std::string_view name) {
  constexpr std::string_view begin = "mode_";
  if (!name.starts_with(begin)) return false;
  name.remove_prefix(begin.size());
  const auto digits = static_cast<std::size_t>(std::ranges::find_if_not(name, [](unsigned char c) { return std::isdigit(c) != 0; }) - name.begin());
  const std::string_view end = name.substr(digits);
  return digits > 0 && (end == ".webp" || end == "_minus.ply" || end == "_plus.ply" || end == "_minus.csv" || end == "_plus.csv");
}

/// Of a path within the folder of a cohort; files of runs are protected by their own checksums, but are made anew as well.
bool is_written(const fs::path& inside) {
  const std::string first = inside.begin()->string();
  constexpr std::array folders{"model", "runs", "atlas", "mirrored"};
  constexpr std::array files{"atlas.ply", "atlas.csv", "atlas_landmarks.csv", "subjects.csv", "times.csv", "landmarks.csv", "landmarks_on_atlas.csv"};
  return std::ranges::find(folders, first) != folders.end() || std::ranges::find(files, inside.string()) != files.end();
}

}  // namespace

void remove_own_table(const std::string& path, std::string_view first_line) {
  std::ifstream file(path);
  std::string line;
  if (!std::getline(file, line) || line != first_line) return;
  file.close();
  std::error_code error;
  fs::remove(path, error);
}

void remove_model_files(const std::string& folder, StaleFiles what) {
  std::error_code error;
  std::vector<fs::path> found;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    const bool is_statistic = std::ranges::find(statistics_files, name) != statistics_files.end(),
               is_of_points = std::ranges::find(point_files, name) != point_files.end();
    if (is_of_a_mode(name) || (what != StaleFiles::mode_shapes && is_statistic) || (what == StaleFiles::all && is_of_points))
      found.push_back(entry.path());
  }
  for (const fs::path& path : found) fs::remove(path, error);
  if (what == StaleFiles::all) fs::remove(folder, error);  // fails where it holds something else
}

void check_inputs_are_kept(const Cohort& cohort, const std::string& folder) {
  std::vector<std::string> inputs{cohort.options.atlas.shape, cohort.options.atlas.landmarks};
  for (const Subject& subject : cohort.subjects) {
    inputs.push_back(subject.source);
    inputs.push_back(subject.landmarks);
  }
  std::error_code error;
  const fs::path place = fs::weakly_canonical(folder, error);
  for (const std::string& input : inputs) {
    if (input.empty() || !fs::exists(input, error)) continue;
    const fs::path inside = fs::weakly_canonical(input, error).lexically_relative(place);
    if (!inside.empty() && *inside.begin() != ".." && is_written(inside))
      throw_input_error("{}: the cohort in {} writes this file itself; copy it elsewhere, or choose another folder with -o", input, folder);
  }
}

}  // namespace shellmatch
