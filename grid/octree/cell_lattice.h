#pragma once
/// \file
/// The 3^Dim points at the corners of a cell's children: the cell's own corners, the midpoints of its edges
/// and faces, and its centre. The coordinates of point n are the digits of n in base 3, the first axis first:
/// 0 is the lower end, 1 the middle, 2 the upper end. A cell and its neighbours of the same size are numbered
/// in the same way, by their offsets 0 (below), 1 (same) and 2 (above).

#include "base/types.h"

#include <array>

namespace shellmatch {

template <int Dim>
inline constexpr int n_lattice = Dim == 2 ? 9 : 27;

template <int Dim>
constexpr std::array<int, Dim> lattice_point(int number) {
  std::array<int, Dim> p{};
  for (int k = 0; k < Dim; ++k, number /= 3) p[k] = number % 3;
  return p;
}

template <int Dim>
constexpr int lattice_number(const std::array<int, Dim>& point) {
  int number = 0;
  for (int k = Dim - 1; k >= 0; --k) number = 3 * number + point[k];
  return number;
}

/// lattice_step[c] is the number of the point at the lower corner of child c. Corner d of that child is point
/// lattice_step[c] + lattice_step[d]; corner d of the whole cell is point 2 lattice_step[d].
template <int Dim>
inline constexpr auto lattice_step = [] {
  std::array<int, n_corners<Dim>> step{};
  for (int c = 0; c < n_corners<Dim>; ++c)
    for (int k = 0, power = 1; k < Dim; ++k, power *= 3) step[c] += ((c >> k) & 1) * power;
  return step;
}();

/// The midpoint of an edge, of a face or of the cell: a point that splitting the cell adds.
template <int Dim>
struct MiddlePoint {
  struct Elsewhere {
    int neighbour, point;
  };
  int point = 0;
  int n_elsewhere = 0;  ///< number of neighbours that share the point; `point` is its number in each of them
  std::array<Elsewhere, n_corners<Dim> / 2 - 1> elsewhere{};
  int n_ends = 0;  ///< number of corners of that edge, face or cell; `ends` lists them, ascending
  std::array<int, n_corners<Dim>> ends{};
};

template <int Dim>
inline constexpr auto middle_points = [] {
  std::array<MiddlePoint<Dim>, n_lattice<Dim> - n_corners<Dim>> all{};
  int n = 0;
  for (int number = 0; number < n_lattice<Dim>; ++number) {
    const auto p = lattice_point<Dim>(number);
    MiddlePoint<Dim> m{};
    m.point = number;
    for (int c = 0; c < n_corners<Dim>; ++c) {
      bool is_end = true;
      for (int k = 0; k < Dim; ++k) is_end = is_end && (p[k] == 1 || p[k] == 2 * ((c >> k) & 1));
      if (is_end) m.ends[m.n_ends++] = c;
    }
    if (m.n_ends == 1) continue;  // a corner
    for (int neighbour = 0; neighbour < n_lattice<Dim>; ++neighbour) {
      auto there = lattice_point<Dim>(neighbour);
      bool has_it = neighbour != n_lattice<Dim> / 2;
      for (int k = 0; k < Dim; ++k) {
        has_it = has_it && (there[k] == 1 || there[k] == p[k]);
        there[k] = p[k] - 2 * (there[k] - 1);
      }
      if (has_it) m.elsewhere[m.n_elsewhere++] = {neighbour, lattice_number<Dim>(there)};
    }
    all[n++] = m;
  }
  return all;
}();

}  // namespace shellmatch
