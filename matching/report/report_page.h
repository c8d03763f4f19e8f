#pragma once
/// \file
/// The page without its data, made from matching/page/ when the program is built.

#include <string_view>

namespace shellmatch {

/// HTML, in which the comments `<!-- data -->` and `<!-- arrays -->` stand for the description of a result and its
/// packed arrays.
extern const std::string_view report_page;

}  // namespace shellmatch
