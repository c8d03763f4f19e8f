#include "apps/cohorts/output/own_files.h"

#include "base/error.h"
#include "apps/cohorts/cohort.h"
#include "apps/cohorts/execution/run_cohort.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <vector>

namespace shellmatch {

namespace fs = std::filesystem;

namespace {

constexpr std::array mean_files{"mean.ply", "mean.csv", "mean.vtp"};
constexpr std::array statistics_files{"modes.npy", "modes.csv", "scores.csv"};
constexpr std::array point_files{"points.npy", "aligned.npy", "faces.npy", "points.csv", "points.tps"};

/// mode_K_minus.ply, mode_K_plus.csv, mode_K.webp
bool is_of_a_mode(std::string_view name) {
  constexpr std::string_view begin = "mode_";
  if (!name.starts_with(begin)) return false;
  name.remove_prefix(begin.size());
  const auto digits = static_cast<std::size_t>(
      std::ranges::find_if_not(name, [](unsigned char c) { return std::isdigit(c) != 0; }) - name.begin());
  const std::string_view end = name.substr(digits);
  return digits > 0 &&
         (end == ".webp" || end == "_minus.ply" || end == "_plus.ply" || end == "_minus.csv" || end == "_plus.csv");
}

bool is_in(const auto& names, const std::string& name) { return std::ranges::find(names, name) != names.end(); }

bool is_of_a_model(const std::string& name) {
  return is_of_a_mode(name) || is_in(mean_files, name) || is_in(statistics_files, name) || is_in(point_files, name);
}

/// Of a path within the folder of a cohort; files of runs are protected by their own checksums, but are made anew as
/// well.
bool is_written(const fs::path& inside) {
  const std::string first = inside.begin()->string();
  if (first == cohort_folder_kind.files_folder)
    return inside.parent_path() == first && is_of_a_model(inside.filename().string());
  return first == "runs" || is_in(cohort_folder_kind.after_runs, first);
}

/// The path within a folder; empty where it is not in there.
fs::path path_within(const fs::path& folder, const fs::path& path) {
  fs::path inside = path.lexically_relative(folder);
  return !inside.empty() && *inside.begin() == ".." ? fs::path() : inside;
}

/// Whether the cohort is going to write the file, under its own name or under that to which a link leads.
bool is_written_in(const fs::path& folder, const fs::path& file) {
  std::error_code error;
  const fs::path absolute = fs::absolute(file);
  for (const fs::path& name :
       {fs::weakly_canonical(file, error), fs::weakly_canonical(absolute.parent_path(), error) / absolute.filename()})
    if (const fs::path inside = path_within(folder, name); !inside.empty() && is_written(inside)) return true;
  return false;
}

void remove_if(const std::string& path, auto is_own) {
  std::error_code error;
  if (!fs::is_regular_file(fs::symlink_status(path, error))) return;  // a link is somebody's
  std::ifstream file(path);
  std::string line;
  if (!std::getline(file, line) || !is_own(line)) return;
  file.close();
  fs::remove(path, error);
}

}  // namespace

void remove_own_table(const std::string& path, std::string_view first_line) {
  remove_if(path, [&](const std::string& line) { return line == first_line; });
}

void remove_own_landmarks(const std::string& path, std::string_view beginning) {
  remove_if(path, [&](const std::string& line) { return line.starts_with(beginning); });
}

void remove_model_files(const std::string& folder, StaleFiles what, int dimension) {
  std::error_code error;
  std::vector<fs::path> found;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (!fs::is_regular_file(entry.symlink_status(error)))
      continue;  // the program makes neither links nor folders there
    const bool is_mean_of_this = is_in(mean_files, name) && name.ends_with(".csv") == (dimension == 2);
    const bool has_one_now = (what == StaleFiles::mode_shapes && (is_mean_of_this || is_in(statistics_files, name))) ||
                             (what != StaleFiles::all && is_in(point_files, name));
    if (is_of_a_model(name) && !has_one_now) found.push_back(entry.path());
  }
  for (const fs::path& path : found) fs::remove(path, error);
  // Fails where it holds something else; a link would go even then.
  if (what == StaleFiles::all && fs::is_directory(fs::symlink_status(folder, error))) fs::remove(folder, error);
}

void check_inputs_are_kept(const Cohort& cohort, const std::string& folder) {
  std::vector<std::string> files{cohort.options.table, cohort.options.atlas.shape, cohort.options.atlas.landmarks};
  for (const Subject& subject : cohort.subjects) {
    files.push_back(subject.source);
    files.push_back(subject.landmarks);
  }
  std::error_code error;
  const fs::path place = fs::weakly_canonical(folder, error);
  for (const std::string& file : files)
    if (!file.empty() && fs::exists(file, error) && is_written_in(place, file))
      throw_input_error(
          "{}: the cohort in {} writes this file itself; copy it elsewhere, or choose another folder with -o", file,
          folder);
}

}  // namespace shellmatch
