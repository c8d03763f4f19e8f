#pragma once
/// \file
/// From a JSON document to its text and back. The library's writer and parser are templates; they are compiled here alone, not
/// with every source that makes a document. Shows the library's types.

#include <nlohmann/json.hpp>

#include <iosfwd>
#include <string>

namespace shellmatch {

using Json = nlohmann::ordered_json;

/// Indented by two blanks, with a newline at the end. Texts such as names of files may hold any bytes; those that are no
/// UTF-8 are replaced.
std::string json_text(const Json& json);

/// \throws Json::exception for what is no JSON
Json parse_json(std::istream& in);

}  // namespace shellmatch
