#pragma once
/// \file
/// XML for the readers in this folder: names without the prefix of their namespace, and numbers in texts.

#include "base/types.h"

#include <pugixml.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace shellmatch {

/// \param bytes which the document refers to no more \throws InputError that names the file and what of it is no XML
void parse_xml(const std::string& path, std::string_view bytes, pugi::xml_document& document);

/// Without a prefix, "p:path" being "path".
std::string_view local_name(const char* name);
inline std::string_view local_name(const pugi::xml_node& node) { return local_name(node.name()); }

/// The first child, or the first attribute, of that local name; empty where there is none.
pugi::xml_node child_of(const pugi::xml_node& node, std::string_view name);
std::string_view attribute_of(const pugi::xml_node& node, std::string_view name);

/// All children of that local name.
std::vector<pugi::xml_node> children_of(const pugi::xml_node& node, std::string_view name);

/// All numbers between blanks. \param what of the file they are, for messages \throws InputError where a word is none
std::vector<double> numbers_in(const std::string& path, std::string_view text, std::string_view what);
/// The same of whole numbers, of which each is at least 0 and an Index.
std::vector<Index> indices_in(const std::string& path, std::string_view text, std::string_view what);

}  // namespace shellmatch
