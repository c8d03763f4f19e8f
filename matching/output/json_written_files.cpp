#include "matching/json/json_members.h"
#include "matching/output/written_files.h"

namespace shellmatch {

struct FileList {
  int format = 1;
  std::vector<WrittenFile> files;
};

SHELLMATCH_JSON(WrittenFile, name, bytes, checksum)
SHELLMATCH_JSON(FileList, format, files)

std::string file_list_json(const std::vector<WrittenFile>& files) {
  return json_text(json_of(FileList{.files = files}));
}

std::optional<std::vector<WrittenFile>> parse_file_list(const std::string& path) {
  std::optional<FileList> list = read_json<FileList>(path);
  if (!list || list->format != FileList().format) return std::nullopt;
  return std::move(list->files);
}

}  // namespace shellmatch
