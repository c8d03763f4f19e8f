#pragma once
/// \file
/// The tags of an XML text one by one: enough of XML for the head of a file that this program wrote.

#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace shellmatch {

struct XmlTag {
  std::string_view name;
  bool closes = false;       ///< of the form `</name>`
  bool is_complete = false;  ///< of the form `<name ... />`
  std::vector<std::pair<std::string_view, std::string_view>> attributes;

  /// The value of the attribute; nothing where there is none.
  std::optional<std::string_view> find(std::string_view key) const;
};

/// Takes the next tag off the front of `text`. Text between tags, comments and declarations are passed over; attributes
/// with references (&amp;) are not understood. Nothing at the end, and where the tag is no XML: `text` is then not
/// empty.
std::optional<XmlTag> next_tag(std::string_view& text);

}  // namespace shellmatch
