#include "matching/output/output_folder.h"

#include "base/error.h"
#include "base/replace_file.h"
#include "matching/output/hidden_names.h"
#include "matching/output/leftovers.h"
#include "matching/output/write_file.h"
#include "matching/output/written_files.h"

#include <fcntl.h>
#include <stdio.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <vector>

namespace shellmatch {

namespace fs = std::filesystem;

namespace {

// A directory that is open takes 32 kB in glibc; pictures/ lies in the hidden folder.
constexpr std::size_t n_reserved_bytes = 3 << 15;

// Whether an existing folder has to be filled where it is, because nothing beside it can be renamed to it.
bool is_filled_in_place(const fs::path& folder) {
  std::error_code error;
  return fs::is_directory(folder, error) &&
         (::access(folder.parent_path().c_str(), W_OK) != 0 || is_mount_point(folder));
}

// Moves the entries that belong to no lock or hidden folder of `name`. \return 0, or the system's error
int move_entries(const fs::path& from, const fs::path& to, const std::string& name, bool list_first,
                 std::vector<std::string>& moved) {
  std::error_code error;
  std::vector<std::string> entries;
  for (const fs::directory_entry& entry : fs::directory_iterator(from, error))
    if (std::string file = entry.path().filename().string(); !is_hidden_name(file, name))
      entries.push_back(std::move(file));
  if (error) return error.value();
  std::ranges::partition(entries, [&](const std::string& file) { return (file == written_files_name) == list_first; });
  for (const std::string& file : entries) {
    // What came into being there after it was checked is not replaced.
    if (const int cause = rename_to_new((from / file).string(), (to / file).string()); cause != 0) return cause;
    moved.push_back(file);
  }
  return 0;
}

// The list names files alone, so that a folder without any would be of no run: that of pictures, none of which could be
// drawn.
void remove_empty_folders(const fs::path& top) {
  std::error_code error;
  std::vector<fs::path> folders;
  for (auto at = fs::recursive_directory_iterator(top, error); !error && at != fs::end(at); at.increment(error))
    if (at->is_directory()) folders.push_back(at->path());
  for (auto inner = folders.rbegin(); inner != folders.rend(); ++inner) fs::remove(*inner, error);
}

void check_place(const fs::path& path, bool force, ChangedFiles changed) {
  if (!is_filled(path)) return;
  if (!fs::is_directory(path))
    throw_input_error(
        "{}: is a file or a link that leads nowhere, but a folder is to be written there; choose another name with -o",
        path.string());
  std::error_code error;
  const fs::directory_iterator look(path, error);
  if (error)
    throw_environment_error("{}: cannot be looked into ({}); choose another folder with -o", path.string(),
                            error.message());
  if (!force)
    throw_input_error("{}: the folder exists and is not empty; choose another with -o, or replace it with --force",
                      path.string());
  if (const ForeignThing thing = first_foreign_thing(path.string(), changed))
    throw_input_error(
        "{}: not replaced, since {}; move that elsewhere, remove the folder yourself, or choose another with -o",
        path.string(), foreign_text(thing));
}

}  // namespace

void check_inputs_outlive(const std::string& path, std::span<const std::string> inputs) {
  std::error_code error;
  const fs::path place = fs::weakly_canonical(path, error);
  for (const std::string& input : inputs) {
    if (input.empty() || !fs::exists(input, error)) continue;
    const fs::path inside = fs::weakly_canonical(input, error).lexically_relative(place);
    if (!inside.empty() && *inside.begin() != "..")
      throw_input_error(
          "{}: the result made from it would replace it; copy it elsewhere, or choose another folder with -o", input);
  }
}

OutputFolder::OutputFolder(const std::string& path, bool force, ChangedFiles changed)
    : force_(force), changed_(changed), reserve_(std::make_unique<std::byte[]>(n_reserved_bytes)) {
  if (path.empty()) throw_input_error("the output folder has no name; give one with -o");
  std::error_code error;
  fs::path place = fs::weakly_canonical(fs::absolute(path), error);  // resolves links, so that their target is replaced
  if (error) cannot_write(path, error.value());
  if (!place.has_filename()) place = place.parent_path();
  if (!place.has_filename()) throw_input_error("{}: cannot be the output folder; give another with -o", path);
  check_place(place, force_, changed_);
  final_ = place.string();
  in_place_ = is_filled_in_place(place);
  // Where the final folder is filled in place, everything that belongs beside it is in it.
  const fs::path anchor = in_place_ ? place / place.filename() : place;

  const fs::path parent = place.parent_path();
  for (fs::path p = parent; !p.empty() && !fs::exists(p, error) && p != p.parent_path(); p = p.parent_path())
    first_created_parent_ = p.string();
  fs::create_directories(parent, error);
  if (error) {
    remove_created_parents();
    cannot_write(parent.string(), error.value());
  }
  try {
    prepare(anchor.string());
  } catch (...) {
    lock_.reset();  // its file lies in a folder that may have been created
    remove_created_parents();
    throw;
  }
}

void OutputFolder::prepare(const std::string& anchor) {
  const std::string parent = fs::path(anchor).parent_path().string();
  if (::access(parent.c_str(), W_OK) != 0) cannot_write(parent, errno);
  lock_.emplace(lock_name(anchor), FileLock::Kind::exclusive);
  if (lock_->state() == FileLock::State::taken)
    throw_input_error("{}: another run is writing there; wait for its end or choose another folder with -o", final_);
  if (lock_->state() == FileLock::State::held) remove_partial_folders(anchor, holds_result(final_));
  // Without locks, leftovers may have the name: count up until it is free.
  std::error_code error;
  for (int attempt = 0; partial_.empty(); ++attempt) {
    const std::string hidden =
        partial_folder_name(anchor) + (attempt == 0 ? std::string() : fmt::format("-{}", attempt));
    if (fs::create_directory(hidden, error)) partial_ = hidden;
    if (error || attempt > 1000) cannot_write(parent, error ? error.value() : EEXIST);
  }
}

OutputFolder::~OutputFolder() {
  if (committed_) return;
  reserve_.reset();
  std::error_code ignored;
  fs::remove_all(partial_, ignored);
  lock_.reset();
  remove_created_parents();
}

void OutputFolder::remove_created_parents() noexcept {
  if (first_created_parent_.empty()) return;
  std::error_code error;
  // Removes only folders that are empty: other processes may use them by now.
  for (fs::path p = fs::path(final_).parent_path(); fs::remove(p, error) && p.string() != first_created_parent_;)
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
  remove_empty_folders(partial_);
  write_file_list(partial_);
  std::vector<std::string> folders{partial_};
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(partial_, error)) {
    if (entry.is_directory()) folders.push_back(entry.path().string());
    else synchronise_file(entry.path().string());
  }
  if (error) cannot_write(partial_, error.value());
  for (const std::string& folder : folders) synchronise_file(folder);

  check_place(final_, force_, changed_);  // it may have been filled during the run
  if (in_place_) {
    fill_in_place();
  } else if (is_filled(final_)) {
    exchange();
  } else {
    fs::rename(partial_, final_, error);  // replaces an empty folder
    if (error) cannot_write(final_, error.value());
    committed_ = true;
    synchronise(fs::path(final_).parent_path().string());
  }
  lock_.reset();
}

// Exchanges both folders in one step. File systems without this operation need two, between which the old folder is
// kept under a hidden name.
void OutputFolder::exchange() {
  if (::renameat2(AT_FDCWD, partial_.c_str(), AT_FDCWD, final_.c_str(), RENAME_EXCHANGE) == 0) {
    committed_ = true;
    // The new name is on the disk before the earlier result goes.
    synchronise(fs::path(final_).parent_path().string());
    return remove_earlier(partial_);
  }
  const std::string old = partial_ + std::string(set_aside);
  std::error_code error;
  fs::rename(final_, old, error);
  if (error) cannot_write(final_, error.value());
  fs::rename(partial_, final_, error);
  if (error) {
    const int cause = error.value();
    fs::rename(old, final_, error);
    cannot_write(final_, cause);
  }
  committed_ = true;
  synchronise(fs::path(final_).parent_path().string());
  remove_earlier(old);
}

// Moves the files one by one. Where a kill comes between, the files that are in the final folder stand in its list:
// that of the earlier result goes last, that of this one comes first. If moving fails, everything goes back to where it
// was.
void OutputFolder::fill_in_place() {
  const std::string name = fs::path(final_).filename().string(), old = partial_ + std::string(set_aside);
  std::error_code error;
  std::vector<std::string> earlier, now;
  int cause = 0;
  if (is_filled(final_)) {
    fs::create_directory(old, error);
    cause = error ? error.value() : move_entries(final_, old, name, false, earlier);
  }
  if (cause == 0) cause = move_entries(partial_, final_, name, true, now);
  if (cause != 0) {
    for (const std::string& file : now) fs::rename(fs::path(final_) / file, fs::path(partial_) / file, error);
    for (const std::string& file : earlier) fs::rename(fs::path(old) / file, fs::path(final_) / file, error);
    fs::remove(old, error);
    cannot_write(final_, cause);
  }
  committed_ = true;
  synchronise(final_);
  fs::remove(partial_, error);
  if (!earlier.empty()) remove_earlier(old);
}

// What came into the folder after it was checked is kept under a name that no run uses. Files of the earlier run that
// the system does not remove stay under the hidden name, and the next run removes them.
void OutputFolder::remove_earlier(const std::string& folder) {
  remove_written_files(folder);
  std::error_code error;
  if (first_foreign_thing(folder, ChangedFiles::are_written))
    fs::rename(folder, fmt::format("{}.kept-{}", final_, ::getpid()), error);
}

}  // namespace shellmatch
