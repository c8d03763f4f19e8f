#pragma once
/// \file
/// The page of a cohort without its data, made from matching/page/ when the program is built.

#include <string_view>

namespace shellmatch {

/// HTML, in which the comments `<!-- data -->` and `<!-- arrays -->` stand for the description of a cohort and its
/// packed arrays.
extern const std::string_view cohort_page;

}  // namespace shellmatch
