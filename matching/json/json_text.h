#pragma once
/// \file
/// Conversion between JSON documents and text. The library's writer and parser are templates, which are compiled here
/// alone. It exposes types of the JSON library.
/// with every source that makes a document. Shows the library's types.

#include <nlohmann/json.hpp>

#include <iosfwd>
#include <string>

namespace shellmatch {

using Json = nlohmann::ordered_json;

/// The document as text, indented by two blanks, with a newline at the end. Bytes that are not UTF-8, as in file names,
/// are replaced.
std::string json_text(const Json& json);

/// Parses a document. \throws Json::exception for invalid JSON
Json parse_json(std::istream& in);

}  // namespace shellmatch
