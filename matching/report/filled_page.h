#pragma once
/// \file
/// A page and its data.

#include <string>
#include <string_view>

namespace shellmatch {

/// \param page with the comments `<!-- data -->` and `<!-- arrays -->`, in whose places the texts come
/// \param data JSON without '<' \param arrays base64
std::string filled_page(std::string_view page, std::string_view data, std::string_view arrays);

}  // namespace shellmatch
