#pragma once
/// \file
/// Detection of folds. On each cell det Dphi is a polynomial, of degree 2 in each direction for trilinear and of degree
/// 1 for bilinear maps. Its Bernstein coefficients bound it from both sides: positive coefficients certify det Dphi > 0
/// throughout the cell.

#include "energies/elements/unknowns.h"

#include <span>
#include <vector>

namespace shellmatch {

struct FoldReport {
  double min_determinant = 0;  ///< smallest value of det Dphi at the corners of cells
  double lower_bound = 0;      ///< smallest Bernstein coefficient: det Dphi is nowhere smaller
  Index n_folded_cells = 0;    ///< cells with det Dphi <= 0 at one of their corners, or not a number
  Index n_uncertified_cells =
      0;  ///< cells with a Bernstein coefficient <= 0 or not a number; 0 certifies that there is no fold
  double folded_volume = 0;  ///< volume of the folded cells, as a share of the domain
};

/// Bounds of det Dphi on one element.
struct DeterminantBounds {
  double smallest;  ///< smallest value at a corner
  double bound;     ///< smallest Bernstein coefficient, <= smallest; both NaN where the map is not finite
};

/// The bounds of each element.
template <int Dim>
std::vector<DeterminantBounds> determinant_bounds(std::span<const Element<Dim>> elements,
                                                  std::span<const Vec<Dim>> phi);

template <int Dim>
FoldReport find_folds(std::span<const Element<Dim>> elements, std::span<const Vec<Dim>> phi);

}  // namespace shellmatch
