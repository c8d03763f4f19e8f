#pragma once
/// \file
/// What is in a TPS file, for `inspect`.

#include "geometry/outline/tps_file.h"

#include <optional>
#include <string>
#include <vector>

namespace shellmatch {

/// The specimens that a name stands for, "wings.tps" or "wings.tps:ID", where that is no outline: several, or one of
/// landmarks alone. Nothing of other names. \throws InputError where the file cannot be read
std::optional<std::vector<TpsSpecimen>> listed_specimens(const std::string& source);

/// In words, and as a JSON object with the landmarks times their scale. \pre there are some
std::string specimens_text(const std::string& source, const std::vector<TpsSpecimen>& specimens);
std::string specimens_json(const std::string& source, const std::vector<TpsSpecimen>& specimens);

}  // namespace shellmatch
