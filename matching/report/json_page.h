#pragma once
/// \file
/// What the descriptions of all pages share. For the sources that write JSON; it exposes types of the JSON library.

#include "matching/json/json_text.h"
#include "matching/report/packed_arrays.h"
#include "matching/report/page.h"

#include <optional>
#include <string>
#include <vector>

namespace shellmatch {

/// Adds `format`, `program`, `libraries`, `arrays` and, where there is a view, `camera`.
void add_page_members(Json& page, const std::vector<PackedArray>& arrays, const std::optional<PageView>& view);

/// As text that may stand within an element of a page: it has no '<'. Bytes that are not UTF-8 are replaced.
std::string element_text(const Json& page);

}  // namespace shellmatch
