#include "matching/json/json_members.h"
#include "matching/output/written_files.h"

#include <fstream>

namespace shellmatch {

struct FileList {
  int format = 1;
  std::vector<WrittenFile> files;
};

template <class S, class Member>
requires std::is_same_v<std::remove_const_t<S>, WrittenFile>
static void describe(S& s, Member&& member) {
  member("name", s.name);
  member("bytes", s.bytes);
  member("checksum", s.checksum);
}

template <class S, class Member>
requires std::is_same_v<std::remove_const_t<S>, FileList>
static void describe(S& s, Member&& member) {
  member("format", s.format);
  member("files", s.files);
}

std::string file_list_json(const std::vector<WrittenFile>& files) {
  return json_text(json_of(FileList{.files = files}));
}

std::optional<std::vector<WrittenFile>> parse_file_list(const std::string& path) {
  std::ifstream in(path);
  if (!in) return std::nullopt;
  try {
    FileList list;
    set_from_json(parse_json(in), list);
    if (list.format == FileList().format) return std::move(list.files);
  } catch (const Json::exception&) {
    // A damaged list counts as none.
  }
  return std::nullopt;
}

}  // namespace shellmatch
