#include "matching/output/leftovers.h"

#include "base/error.h"
#include "matching/output/file_lock.h"
#include "matching/output/hidden_names.h"
#include "matching/output/written_files.h"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <set>
#include <utility>
#include <vector>

namespace shellmatch {

namespace fs = std::filesystem;

bool is_filled(const std::string& path) {
  std::error_code error;
  if (!fs::exists(path, error)) return fs::is_symlink(path, error);
  if (!fs::is_directory(path, error)) return true;
  const std::string name = fs::path(path).filename().string();
  const bool is_filled = std::ranges::any_of(
      fs::directory_iterator(path, error),
      [&](const fs::directory_entry& entry) { return !is_hidden_name(entry.path().filename().string(), name); });
  return is_filled || error;
}

void remove_partial_folders(const std::string& path, bool is_replaced) {
  const fs::path place = path;
  std::error_code error;
  std::vector<fs::path> found;
  for (const fs::directory_entry& entry : fs::directory_iterator(place.parent_path(), error))
    if (const std::string name = entry.path().filename().string();
        is_partial_folder_name(name, place.filename().string()) && (!name.ends_with(set_aside) || is_replaced))
      found.push_back(entry.path());
  for (const fs::path& partial : found) {
    // What was set aside has been an output folder, in which others may have put something.
    if (partial.native().ends_with(set_aside) && is_filled(partial.string())) remove_written_files(partial.string());
    else fs::remove_all(partial, error);
  }
}

void remove_leftovers(const std::string& path) {
  const FileLock lock(lock_name(path), FileLock::Kind::exclusive);
  if (lock.state() == FileLock::State::held) remove_partial_folders(path, holds_result(path));
}

void remove_hidden(const std::string& path) noexcept try {
  remove_partial_folders(path, holds_result(path));
  std::error_code error;
  fs::remove(lock_name(path), error);
} catch (const std::exception&) {
  // They stay; nothing reads them.
}

void remove_leftovers_in(const std::string& parent) {
  std::set<std::string> outputs;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(parent, error))
    if (std::string name = name_of_output(entry.path().filename().string()); !name.empty())
      outputs.insert(std::move(name));
  for (const std::string& name : outputs) try {
      remove_leftovers((fs::path(parent) / name).string());
    } catch (const EnvironmentError&) {
      // It may belong to another user; a run for that output folder will report it.
    }
}

}  // namespace shellmatch
