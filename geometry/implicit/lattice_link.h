#pragma once
/// \file
/// The neighbours of a point of the body-centred cubic lattice. With the lattice edges between them they form
/// a triangulated sphere, the link of the point.

#include <array>

namespace shellmatch {

/// The neighbours of a site of the body-centred cubic lattice.
inline constexpr int n_lattice_neighbours = 14;

/// Their offsets in half sides of a cube: 8 across short edges, then 6 across long ones.
inline constexpr std::array<std::array<int, 3>, n_lattice_neighbours> lattice_neighbour_offsets{{{-1, -1, -1},
                                                                                                 {1, -1, -1},
                                                                                                 {-1, 1, -1},
                                                                                                 {1, 1, -1},
                                                                                                 {-1, -1, 1},
                                                                                                 {1, -1, 1},
                                                                                                 {-1, 1, 1},
                                                                                                 {1, 1, 1},
                                                                                                 {-2, 0, 0},
                                                                                                 {2, 0, 0},
                                                                                                 {0, -2, 0},
                                                                                                 {0, 2, 0},
                                                                                                 {0, 0, -2},
                                                                                                 {0, 0, 2}}};

/// True if the surface divides the link, whose vertices have these values, into two connected parts. Then the
/// surface is a disc near the point, also after the point has been moved onto it.
bool link_is_cut_in_two(const std::array<double, n_lattice_neighbours>& values);

}  // namespace shellmatch
