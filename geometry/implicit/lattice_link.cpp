#include "geometry/implicit/lattice_link.h"

namespace shellmatch {

namespace {

bool are_neighbours(const std::array<int, 3>& a, const std::array<int, 3>& b) {
  int squared = 0;
  for (int k = 0; k < 3; ++k) squared += (a[k] - b[k]) * (a[k] - b[k]);
  return squared == 3 || squared == 4;
}

// Bit r of entry q is set if the neighbours q and r are neighbours of each other.
const std::array<unsigned, n_lattice_neighbours>& links() {
  static const auto table = [] {
    std::array<unsigned, n_lattice_neighbours> t{};
    for (int q = 0; q < n_lattice_neighbours; ++q)
      for (int r = 0; r < n_lattice_neighbours; ++r)
        if (are_neighbours(lattice_neighbour_offsets[q], lattice_neighbour_offsets[r])) t[q] |= 1u << r;
    return t;
  }();
  return table;
}

// True if the set of neighbours (a bit for each) is not empty and connected along lattice edges.
bool connected(unsigned set) {
  unsigned reached = set & (~set + 1);  // its lowest bit
  for (unsigned before = 0; before != reached;) {
    before = reached;
    for (int q = 0; q < n_lattice_neighbours; ++q)
      if (before >> q & 1) reached |= links()[q] & set;
  }
  return set != 0 && reached == set;
}

}  // namespace

bool link_is_cut_in_two(const std::array<double, n_lattice_neighbours>& values) {
  unsigned inside = 0, outside = 0;
  for (int q = 0; q < n_lattice_neighbours; ++q) {
    inside |= static_cast<unsigned>(values[q] < 0) << q;
    outside |= static_cast<unsigned>(values[q] > 0) << q;
  }
  constexpr unsigned all = (1u << n_lattice_neighbours) - 1;
  return connected(inside) && connected(outside) && connected(all & ~inside) && connected(all & ~outside);
}

}  // namespace shellmatch
