#include "matching/output/output_folder.h"

#include "base/error.h"
#include "matching/output/leftovers.h"
#include "matching/output/write_file.h"

#include <fcntl.h>
#include <stdio.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <iterator>
#include <vector>

namespace shellmatch {

namespace fs = std::filesystem;

namespace {

// Whether an earlier run has written this folder.
bool looks_like_output(const fs::path& folder) {
  for (const char* name : {"summary.json", "history.csv", "deformation.vtu"})
    if (fs::is_regular_file(folder / name)) return true;
  return false;
}

// Whether a command writes a file of this name into its output folder. A study has that of a run in `output`; pictures
// are PNG.
bool is_written_by_runs(std::string_view name) {
  constexpr std::string_view names[] = {"summary.json", "history.csv",   "deformation.vtu", "deformed.ply", "deformed.csv",
                                        "config.yaml",  "curvature.ply", "curvature.csv",   "result.json",  "log.txt",
                                        "README.txt",   "state.json",    "output",          "pictures"};
  constexpr std::string_view of_study = "output/", of_pictures = "pictures/";
  if (name.starts_with(of_study)) name.remove_prefix(of_study.size());
  if (name.starts_with(of_pictures)) return name.ends_with(".png") && name.find('/', of_pictures.size()) == name.npos;
  return std::ranges::find(names, name) != std::end(names);
}

// The first entry of the folder that no run has written; empty if there is none.
std::string foreign_thing(const fs::path& folder) {
  std::error_code error;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder, error))
    if (std::string name = entry.path().lexically_relative(folder).generic_string(); !is_written_by_runs(name)) return name;
  return "";
}

void check_place(const fs::path& path, bool force) {
  if (!is_filled(path)) return;
  if (!fs::is_directory(path))
    throw_input_error("{}: is a file, but a folder is to be written there; choose another name with -o",
                      path.string());
  if (!force)
    throw_input_error(
        "{}: the folder exists and is not empty; choose another with -o, or replace it with --force",
        path.string());
  if (!looks_like_output(path))
    throw_input_error(
        "{}: not replaced, since it holds no summary.json, history.csv or deformation.vtu and so is no "
        "output folder of an earlier run; choose another with -o",
        path.string());
  if (const std::string name = foreign_thing(path); !name.empty())
    throw_input_error("{}: not replaced, since '{}' in it is of no run; move that elsewhere or choose another folder with -o",
                      path.string(), name);
}

}  // namespace

OutputFolder::OutputFolder(const std::string& path, bool force) : force_(force) {
  if (path.empty()) throw_input_error("the output folder has no name; give one with -o");
  std::error_code error;
  fs::path place =
      fs::weakly_canonical(fs::absolute(path), error);  // resolves links, so that their target is replaced
  if (error) cannot_write(path, error.value());
  if (!place.has_filename()) place = place.parent_path();
  if (!place.has_filename()) throw_input_error("{}: cannot be the output folder; give another with -o", path);
  check_place(place, force);
  final_ = place.string();

  const fs::path parent = place.parent_path();
  for (fs::path p = parent; !p.empty() && !fs::exists(p, error) && p != p.parent_path(); p = p.parent_path())
    first_created_parent_ = p.string();
  fs::create_directories(parent, error);
  if (error) {
    remove_created_parents();
    cannot_write(parent.string(), error.value());
  }
  if (::access(parent.c_str(), W_OK) != 0) cannot_write(parent.string(), errno);
  lock_.emplace(lock_name(place), FileLock::Kind::exclusive);
  if (lock_->state() == FileLock::State::taken)
    throw_input_error("{}: another run is writing there; wait for its end or choose another folder with -o", final_);
  if (lock_->state() == FileLock::State::held) remove_partial_folders(place);
  // Without locks, leftovers may have the name: count up until it is free.
  for (int attempt = 0; partial_.empty(); ++attempt) {
    const std::string suffix = attempt == 0 ? std::string() : fmt::format("-{}", attempt);
    const fs::path hidden = partial_folder_name(final_) + suffix;
    if (fs::create_directory(hidden, error)) partial_ = hidden.string();
    if (error || attempt > 1000) {
      remove_created_parents();
      cannot_write(parent.string(), error ? error.value() : EEXIST);
    }
  }
}

OutputFolder::~OutputFolder() {
  if (committed_) return;
  std::error_code ignored;
  fs::remove_all(partial_, ignored);
  lock_.reset();
  remove_created_parents();
}

void OutputFolder::remove_created_parents() noexcept {
  if (first_created_parent_.empty()) return;
  std::error_code error;
  // Removes only folders that are empty: other processes may use them by now.
  for (fs::path p = fs::path(final_).parent_path();
       fs::remove(p, error) && p.string() != first_created_parent_;)
    p = p.parent_path();
}

std::string OutputFolder::path_of(std::string_view name) {
  const fs::path path = fs::path(partial_) / name;
  std::error_code error;
  fs::create_directories(path.parent_path(), error);
  if (error) cannot_write(path.parent_path().string(), error.value());
  return path.string();
}

void OutputFolder::commit() {
  SHELLMATCH_CHECK(!committed_, "an output folder is committed once");
  std::error_code error;
  std::vector<std::string> folders{partial_};
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(partial_, error)) {
    if (entry.is_directory())
      folders.push_back(entry.path().string());
    else
      synchronise_file(entry.path().string());
  }
  if (error) cannot_write(partial_, error.value());
  for (const std::string& folder : folders) synchronise_folder(folder);

  check_place(final_, force_);  // it may have been filled during the run
  if (is_filled(final_)) {
    // Exchanges both folders in one step. File systems without this operation need two, between which the old folder is
    // kept under a hidden name.
    if (::renameat2(AT_FDCWD, partial_.c_str(), AT_FDCWD, final_.c_str(), RENAME_EXCHANGE) == 0) {
      committed_ = true;
      fs::remove_all(partial_, error);
      lock_.reset();
      return;
    }
    const std::string old = partial_ + std::string(set_aside);
    fs::rename(final_, old, error);
    if (error) cannot_write(final_, error.value());
    fs::rename(partial_, final_, error);
    if (error) {
      const int cause = error.value();
      fs::rename(old, final_, error);
      cannot_write(final_, cause);
    }
    committed_ = true;
    fs::remove_all(old, error);
    lock_.reset();
    return;
  }
  fs::rename(partial_, final_, error);  // replaces an empty folder
  if (error) cannot_write(final_, error.value());
  committed_ = true;
  lock_.reset();
}

}  // namespace shellmatch
