#include "matching/json/json_members.h"
#include "matching/checkpoint/checkpoints.h"

namespace shellmatch {

SHELLMATCH_JSON(CheckpointManifest, format, level, program, reference, (template_shape, template), landmarks)

std::string manifest_json(const CheckpointManifest& manifest) { return json_text(json_of(manifest)); }

std::optional<CheckpointManifest> read_manifest(const std::string& path) { return read_json<CheckpointManifest>(path); }

}  // namespace shellmatch
