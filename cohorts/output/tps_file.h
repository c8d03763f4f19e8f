#pragma once
/// \file
/// Points that correspond, as text for geometric morphometrics.

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace shellmatch {

/// A specimen of a TPS file (F. James Rohlf's tpsDig; R: geomorph's readland.tps()): LM= or LM3= with the number of points, a line for
/// each, ID= with the name. \param coordinates of the points, `dimension` (2 or 3) for each
std::string tps_specimen(std::string_view name, std::span<const double> coordinates, std::size_t dimension);

}  // namespace shellmatch
