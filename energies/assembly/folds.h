#pragma once
/// \file
/// Where does the map fold? det Dphi is a polynomial on each cell: of degree 2 in each direction for trilinear
/// maps and of degree 1 for bilinear ones. Its Bernstein coefficients bound it from both sides, so that positive
/// coefficients certify det Dphi > 0 throughout the cell.

#include "energies/elements/unknowns.h"

#include <span>
#include <vector>

namespace shellmatch {

struct FoldReport {
  double min_determinant = 0;    ///< smallest value of det Dphi found (at 2 or 3 points per direction)
  double lower_bound = 0;        ///< smallest Bernstein coefficient: det Dphi is nowhere smaller
  Index n_folded_cells = 0;      ///< cells with det Dphi <= 0 at one of the points
  Index n_uncertified_cells = 0; ///< cells with a Bernstein coefficient <= 0; 0 certifies that there is no fold
  double folded_volume = 0;      ///< volume of the folded cells, as a share of the domain
};

/// Of det Dphi on one element.
struct DeterminantBounds {
  double smallest;  ///< value at the corners
  double bound;     ///< smallest Bernstein coefficient
};

/// One for each element.
template <int Dim>
std::vector<DeterminantBounds> determinant_bounds(std::span<const Element<Dim>> elements,
                                                  std::span<const Vec<Dim>> phi);

template <int Dim>
FoldReport find_folds(std::span<const Element<Dim>> elements, std::span<const Vec<Dim>> phi);

}  // namespace shellmatch
