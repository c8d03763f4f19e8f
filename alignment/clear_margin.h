#pragma once
/// \file
/// When the best of several maps is clearly so.

namespace shellmatch {

/// The factor by which all other maps score worse, for maps of whole surfaces and for those of parts.
inline constexpr double clear_margin = 1.15, clear_margin_of_part = 1.2;

}  // namespace shellmatch
