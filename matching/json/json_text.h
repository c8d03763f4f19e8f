#pragma once
/// \file
/// Conversion between JSON documents and text. The library's writer and parser are templates, which are compiled here
/// alone. It exposes types of the JSON library.

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

/// The document as CBOR (RFC 8949), which keeps every number to the bit, infinite ones, too.
std::string json_bytes(const Json& json);

/// \throws Json::exception for bytes that are no CBOR
Json parse_json_bytes(const std::string& bytes);

}  // namespace shellmatch
