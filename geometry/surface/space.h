#pragma once
/// \file
/// The anatomical frame of coordinates. RAS: x to the patient's right, y to the front, z upward; LPS: x to the left, y
/// to the back, z upward. 3D Slicer names the frame of what it saves, ITK's formats are LPS.

#include "base/types.h"

#include <string_view>
#include <vector>

namespace shellmatch {

/// The numbers stand in files of maps.
enum class Space { unsaid = 0, ras = 1, lps = 2 };

/// The frame of shapes and maps that name none: points that do name one are converted to it.
inline constexpr Space default_space = Space::ras;

inline Space or_default(Space space) { return space == Space::unsaid ? default_space : space; }

/// The frame that the comment of a mesh names as 3D Slicer does, "SPACE=LPS"; unsaid where it names none.
Space space_in_comment(std::string_view text);

/// "RAS" or "LPS"; empty where it is unsaid.
std::string_view space_name(Space space);

/// Coordinates of `from` in `to`: x and y change their sign between RAS and LPS. Where either is unsaid nothing
/// changes. The conversion is exact and its own inverse.
Vec<3> in_space(const Vec<3>& x, Space from, Space to);

/// The same of many; true where they have changed.
bool change_space(std::vector<Vec<3>>& points, Space from, Space to);

}  // namespace shellmatch
