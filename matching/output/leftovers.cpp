#include "matching/output/leftovers.h"

#include "base/error.h"
#include "matching/output/file_lock.h"

#include <unistd.h>

#include <filesystem>
#include <set>
#include <utility>
#include <vector>

namespace shellmatch {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view lock_ending = ".lock", partial_infix = ".partial-";

std::string partial_prefix(const fs::path& place) { return fmt::format(".{}{}", place.filename().string(), partial_infix); }

// The name of the output folder to which a lock or a hidden folder belongs; empty for any other name.
std::string name_of_output(std::string_view hidden) {
  if (!hidden.starts_with('.')) return "";
  std::size_t end = hidden.rfind(partial_infix);
  if (end == hidden.npos && hidden.ends_with(lock_ending)) end = hidden.size() - lock_ending.size();
  return end == hidden.npos || end < 2 ? "" : std::string(hidden.substr(1, end - 1));
}

}  // namespace

std::string lock_name(const std::string& path) {
  const fs::path place = path;
  return (place.parent_path() / fmt::format(".{}{}", place.filename().string(), lock_ending)).string();
}

bool is_filled(const std::string& path) {
  std::error_code error;
  return fs::exists(path, error) && !(fs::is_directory(path, error) && fs::is_empty(path, error));
}

void remove_partial_folders(const std::string& path) {
  const fs::path place = path;
  std::error_code error;
  const std::string begin = partial_prefix(place);
  std::vector<fs::path> found;
  for (const fs::directory_entry& entry : fs::directory_iterator(place.parent_path(), error))
    if (const std::string name = entry.path().filename().string();
        name.starts_with(begin) && (!name.ends_with(set_aside) || is_filled(place)))
      found.push_back(entry.path());
  for (const fs::path& partial : found) fs::remove_all(partial, error);
}

std::string partial_folder_name(const std::string& path) {
  const fs::path place = path;
  return (place.parent_path() / fmt::format("{}{}", partial_prefix(place), ::getpid())).string();
}

void remove_leftovers(const std::string& path) {
  const FileLock lock(lock_name(path), FileLock::Kind::exclusive);
  if (lock.state() == FileLock::State::held) remove_partial_folders(path);
}

void remove_leftovers_in(const std::string& parent) {
  std::set<std::string> outputs;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(parent, error))
    if (std::string name = name_of_output(entry.path().filename().string()); !name.empty()) outputs.insert(std::move(name));
  for (const std::string& name : outputs) try {
      remove_leftovers((fs::path(parent) / name).string());
    } catch (const EnvironmentError&) {
      // It may belong to another user; a run for that output folder will report it.
    }
}

}  // namespace shellmatch
