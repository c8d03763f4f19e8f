#pragma once
/// \file
/// files.json: the list of all files that a run wrote into its output folder. Only what stands in that list is ever
/// replaced or removed.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace shellmatch {

inline constexpr const char* written_files_name = "files.json";

struct WrittenFile {
  std::string name;  ///< relative to the folder, as "pictures/result.png"
  std::uint64_t bytes = 0;
  std::string checksum;  ///< matching/output/checksum.h
};

/// Lists the files of a folder and its subfolders, without files.json, sorted by name. \throws InputError or
/// std::filesystem::filesystem_error if one of them cannot be looked at or read
std::vector<WrittenFile> list_files(const std::string& folder);

/// Writes files.json into the folder. \throws EnvironmentError
void write_file_list(const std::string& folder);

/// The list of the folder; nothing where it is missing or damaged.
std::optional<std::vector<WrittenFile>> read_file_list(const std::string& folder);

/// Whether a file whose contents have changed since a run wrote it still counts as the run's.
enum class ChangedFiles { are_foreign, are_written };

/// Something in the folder that is not what a run wrote there: its name relative to the folder; empty if there is none.
/// Files of the list that are missing are no obstacle. A folder without list has nothing of a run.
struct ForeignThing {
  std::string name;
  bool has_changed = false;  ///< it is a file of the list with other contents
  bool no_list = false;      ///< the folder has no list that can be read; `name` is its first entry
  explicit operator bool() const { return !name.empty(); }
};
ForeignThing first_foreign_thing(const std::string& folder, ChangedFiles changed = ChangedFiles::are_foreign);

/// "'thesis' in it is of no run", to be continued with what to do.
std::string foreign_text(const ForeignThing& thing);

/// Whether the folder has a list and each of its files, whatever their contents: a run has ended there, and nothing of
/// its result is still elsewhere.
bool holds_result(const std::string& folder);

/// Removes the files of the list, the list itself and the folders that are empty then. Everything else stays, also if
/// it came after a check, and so does what cannot be removed, with the list; a folder without list stays as it is.
void remove_written_files(const std::string& folder);

/// The text of the list, and its contents; nothing for text that is no list.
std::string file_list_json(const std::vector<WrittenFile>& files);
std::optional<std::vector<WrittenFile>> parse_file_list(const std::string& path);

}  // namespace shellmatch
