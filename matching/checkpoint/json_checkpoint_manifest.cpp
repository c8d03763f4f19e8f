#include "matching/json/json_members.h"
#include "matching/checkpoint/checkpoints.h"

#include <fstream>

namespace shellmatch {

template <class S, class Member>
requires std::is_same_v<std::remove_const_t<S>, CheckpointManifest>
static void describe(S& s, Member&& member) {
  member("format", s.format);
  member("level", s.level);
  member("program", s.program);
  member("reference", s.reference);
  member("template", s.template_shape);
  member("landmarks", s.landmarks);
}

std::string manifest_json(const CheckpointManifest& manifest) { return json_text(json_of(manifest)); }

std::optional<CheckpointManifest> read_manifest(const std::string& path) {
  std::ifstream in(path);
  if (!in) return std::nullopt;
  try {
    CheckpointManifest manifest;
    set_from_json(parse_json(in), manifest);
    return manifest;
  } catch (const Json::exception&) {
    // A damaged manifest counts as none.
  }
  return std::nullopt;
}

}  // namespace shellmatch
