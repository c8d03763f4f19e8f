#pragma once
/// \file
/// Known correspondences, by which the error of a matching is measured.

#include "base/types.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace shellmatch {

/// True positions of some vertices of the reference, in the user's coordinates.
template <int Dim>
using Correspondence = std::vector<std::pair<Index, Vec<Dim>>>;

/// Reads lines "index x y z" (plane: "index x y"); # begins a comment. \throws InputError with file and line
template <int Dim>
Correspondence<Dim> read_correspondence(const std::string& path, std::size_t n_vertices);

/// Mean distance of the vertices from their true positions. \pre truth is not empty
template <int Dim>
double correspondence_error(const Correspondence<Dim>& truth, const std::vector<Vec<Dim>>& vertices);

}  // namespace shellmatch
