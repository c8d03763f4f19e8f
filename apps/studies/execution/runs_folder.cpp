#include "apps/studies/execution/runs_folder.h"

#include "base/error.h"
#include "base/replace_file.h"
#include "matching/output/leftovers.h"

#include <algorithm>
#include <filesystem>

namespace shellmatch {

namespace fs = std::filesystem;

namespace {

// Whether such a folder may contain this name; other entries belong to the user, and so do tables without runs.
bool is_known_entry(const RunsFolderKind& kind, const std::string& name, bool has_runs) {
  const auto is_in = [&](const std::vector<std::string_view>& list) {
    return std::ranges::find(list, name) != list.end();
  };
  return name.starts_with(".") || is_in(kind.before_runs) || (has_runs && (name == "runs" || is_in(kind.after_runs)));
}

// Creates the folder with its subfolders and returns its absolute path. \throws InputError if it belongs to something
// else
std::string prepared(const std::string& path, const RunsFolderKind& kind) {
  const std::string absolute = fs::absolute(path).lexically_normal().string();
  std::error_code error;
  if (fs::exists(absolute, error) && !fs::is_directory(absolute, error))
    throw_input_error("{}: is a file, but a folder is to be written there; choose another name with -o", path);
  // Asked for each entry: another shard may begin meanwhile, which makes `runs` before all else.
  const auto has_runs = [&] { return fs::is_directory(fs::path(absolute) / "runs", error); };
  for (const fs::directory_entry& entry : fs::directory_iterator(absolute, error))
    if (const std::string name = entry.path().filename().string(); !is_known_entry(kind, name, has_runs()))
      throw_input_error("{}: holds {}, which no {} has written; choose another folder with -o", path, name, kind.owner);
  fs::create_directories(fs::path(absolute) / "runs", error);
  if (error) cannot_be_written(error.value(), fmt::format("{}: cannot be written: {}", path, error.message()));
  return absolute;
}

}  // namespace

const RunsFolderKind study_folder_kind{
    "study", {"study.yaml"}, {"table.csv", "convergence.csv", "summary.md", "plots"}, "plots"};

RunsFolder::RunsFolder(const std::string& path, const RunsFolderKind& kind, bool whole)
    : path_(prepared(path, kind)),
      files_folder_(kind.files_folder),
      whole_(whole),
      lock_(path_ + "/.lock", whole ? FileLock::Kind::exclusive : FileLock::Kind::shared) {
  if (lock_.state() == FileLock::State::taken)
    throw_input_error("{}: another process works on a {} there; wait for its end or choose another folder with -o",
                      path, kind.owner);
  remove_leftovers();
}

void RunsFolder::remove_leftovers() const {
  if (!whole_ || lock_.state() != FileLock::State::held) return;
  remove_leftovers_in(path_ + "/runs");
  std::error_code error;
  std::vector<fs::path> found;
  std::vector<std::string> places = {path_};
  if (!files_folder_.empty()) places.push_back(path_ + "/" + files_folder_);
  for (const std::string& place : places)
    for (const fs::directory_entry& entry : fs::directory_iterator(place, error))
      if (is_partial_file_name(entry.path().filename().string()) && fs::is_regular_file(entry.symlink_status(error)))
        found.push_back(entry.path());
  for (const fs::path& path : found) fs::remove(path, error);
}

RunResult RunsFolder::result_of(const RunTask& run) const {
  const auto result = read_run_result(run_folder(run) + "/result.json");
  return result && result->fingerprint == run.fingerprint ? *result : RunResult{};
}

}  // namespace shellmatch
