#include "matching/output/written_files.h"

#include "base/error.h"
#include "base/printable.h"
#include "matching/output/checksum.h"
#include "matching/output/hidden_names.h"
#include "matching/output/write_file.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

namespace shellmatch {

namespace fs = std::filesystem;

namespace {

std::string name_in(const fs::path& folder, const fs::path& path) {
  return path.lexically_relative(folder).generic_string();
}

bool is_real_file(const fs::directory_entry& entry) {
  std::error_code error;
  return fs::is_regular_file(entry.symlink_status(error));
}

bool is_real_folder(const fs::directory_entry& entry) {
  std::error_code error;
  return fs::is_directory(entry.symlink_status(error));
}

// The list as a table, with the folders that lead to its files.
struct Listed {
  std::map<std::string, WrittenFile> files;
  std::set<std::string> folders;

  explicit Listed(std::vector<WrittenFile> list) {
    for (WrittenFile& file : list) {
      for (fs::path p = fs::path(file.name).parent_path(); !p.empty() && p != p.parent_path(); p = p.parent_path())
        folders.insert(p.generic_string());
      const std::string name = file.name;
      files.emplace(name, std::move(file));
    }
  }
};

// Calls visit(entry) for all entries of a folder and its subfolders. \return the error that ended it, if any
template <class Visit>
std::error_code for_each_entry(const std::string& folder, Visit&& visit) {
  std::error_code error;
  for (auto at = fs::recursive_directory_iterator(folder, error); !error && at != fs::end(at); at.increment(error))
    visit(*at);
  return error;
}

bool has_contents(const fs::path& path, const WrittenFile& file) {
  std::error_code error;
  try {
    return fs::file_size(path, error) == file.bytes && !error && file_checksum(path.string()) == file.checksum;
  } catch (const InputError&) {
    return false;  // it cannot be read, so that nothing is known of it
  }
}

}  // namespace

std::vector<WrittenFile> list_files(const std::string& folder) {
  std::vector<WrittenFile> files;
  const std::error_code error = for_each_entry(folder, [&](const fs::directory_entry& entry) {
    // Throws where the status cannot be had: a file that is left out of the list would be of no run.
    if (const std::string name = name_in(folder, entry.path());
        fs::is_regular_file(entry.symlink_status()) && name != written_files_name)
      files.push_back({name, entry.file_size(), file_checksum(entry.path().string())});
  });
  if (error) cannot_write(folder, error.value());
  std::ranges::sort(files, {}, &WrittenFile::name);
  return files;
}

void write_file_list(const std::string& folder) {
  write_file(folder + "/" + written_files_name, file_list_json(list_files(folder)));
}

std::optional<std::vector<WrittenFile>> read_file_list(const std::string& folder) {
  const fs::path path = fs::path(folder) / written_files_name;
  std::error_code error;
  if (!fs::is_regular_file(fs::symlink_status(path, error))) return std::nullopt;
  return parse_file_list(path.string());
}

ForeignThing first_foreign_thing(const std::string& folder, ChangedFiles changed) {
  const auto list = read_file_list(folder);
  const Listed listed(list.value_or(std::vector<WrittenFile>{}));
  std::error_code error;
  const std::string own_name = fs::path(folder).filename().string();
  for (auto at = fs::recursive_directory_iterator(folder, error); !error && at != fs::end(at); at.increment(error)) {
    const fs::directory_entry& entry = *at;
    const std::string name = name_in(folder, entry.path());
    if (is_hidden_name(name, own_name)) {
      at.disable_recursion_pending();  // a run is working in this folder
      continue;
    }
    if (!list) return {.name = name, .no_list = true};
    if (is_real_folder(entry) ? listed.folders.contains(name) : is_real_file(entry) && name == written_files_name)
      continue;
    const auto file = listed.files.find(name);
    if (file == listed.files.end() || !is_real_file(entry)) return {.name = name};
    if (changed == ChangedFiles::are_foreign && !has_contents(entry.path(), file->second))
      return {.name = name, .has_changed = true};
  }
  // What cannot be looked at is not known to be of a run.
  if (error) return {.name = error.message()};
  return {};
}

bool holds_result(const std::string& folder) {
  const auto list = read_file_list(folder);
  std::error_code error;
  return list && std::ranges::all_of(*list, [&](const WrittenFile& file) {
           return fs::is_regular_file(fs::symlink_status(fs::path(folder) / file.name, error));
         });
}

std::string foreign_text(const ForeignThing& thing) {
  if (thing.no_list)
    return fmt::format("it has no {}, in which a run lists what it wrote, so that '{}' in it may be of no run",
                       written_files_name, printable(thing.name));
  return fmt::format("'{}' in it {}", printable(thing.name),
                     thing.has_changed ? "has changed since the run" : "is of no run");
}

void remove_written_files(const std::string& folder) {
  const auto list = read_file_list(folder);
  if (!list) return;
  const Listed listed(*list);
  std::vector<fs::path> files, folders;
  bool is_done = true;
  std::error_code error = for_each_entry(folder, [&](const fs::directory_entry& entry) {
    const std::string name = name_in(folder, entry.path());
    std::error_code unknown;
    const fs::file_status status = entry.symlink_status(unknown);
    if (fs::is_regular_file(status) && listed.files.contains(name)) files.push_back(entry.path());
    if (fs::is_directory(status) && listed.folders.contains(name)) folders.push_back(entry.path());
    if (!fs::status_known(status)) is_done = false;
  });
  if (error) is_done = false;
  for (const fs::path& file : files) is_done = (fs::remove(file, error), !error) && is_done;
  // Inner folders first; those that hold anything else stay.
  std::ranges::sort(folders, std::ranges::greater{}, [](const fs::path& p) { return p.native().size(); });
  for (const fs::path& inner : folders)
    is_done = (fs::remove(inner, error), !error || error == std::errc::directory_not_empty) && is_done;
  if (is_done) fs::remove(fs::path(folder) / written_files_name, error);
  fs::remove(folder, error);
}

}  // namespace shellmatch
