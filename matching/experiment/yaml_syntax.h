#pragma once
/// \file
/// Files and texts as yaml-cpp reads them, where it accepts too much.

#include <optional>
#include <string>

namespace YAML {
class Node;
}

namespace shellmatch {

/// The text of a file. \throws InputError where it is missing, unreadable or larger than 1 MB
std::string read_yaml_file(const std::string& path);

/// The map that is the whole of a text. Messages name it `name`.
/// \throws InputError where the text is empty, has wrong syntax, holds several documents or is no map at the top
YAML::Node parse_yaml_map(const std::string& text, const std::string& name);

/// The column, counted from 1, in which something follows the value that a text denotes; none where it ends with it.
std::optional<int> column_after_value(const std::string& text);

}  // namespace shellmatch
