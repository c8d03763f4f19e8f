#pragma once
/// \file
/// Named points as a file that `--landmarks` reads.

#include "matching/pairs/landmark_file.h"

#include <string>
#include <vector>

namespace shellmatch {

template <int Dim>
inline constexpr const char* named_points_header = Dim == 3 ? "name,x,y,z" : "name,x,y";

/// CSV with the columns name, x, y(, z). \throws EnvironmentError if the file cannot be written
template <int Dim>
void write_named_points(const std::string& path, const std::vector<NamedPoint<Dim>>& points);

}  // namespace shellmatch
