#include "matching/map_file/map_fields.h"

#include "base/parallel.h"
#include "energies/assembly/folds.h"

#include <algorithm>

namespace shellmatch {

template <int Dim>
std::vector<NodalField> nodal_fields(const CoefficientFields<Dim>& reference, const CoefficientFields<Dim>& target,
                                     const ExperimentOptions& options) {
  const auto flat = [](const auto& values, int n) {
    std::vector<double> list;
    list.reserve(values.size() * static_cast<std::size_t>(n));
    for (const auto& v : values)
      for (int k = 0; k < n; ++k) list.push_back(v[k]);
    return list;
  };
  constexpr int n_sym = Dim * (Dim + 1) / 2;  // number of packed entries of a symmetric matrix
  const bool operators = reads_shape_operators(options.energy);
  const char* first = operators ? "S1" : options.coefficients.invert_at_point ? "root_C1" : "inverse_root_C1";
  return {{"d1", 1, reference.distance},
          {"d2", 1, target.distance},
          {"n1", Dim, flat(reference.normal, Dim)},
          {"n2", Dim, flat(target.normal, Dim)},
          {first, n_sym, flat(reference.root, n_sym)},
          {operators ? "S2" : "root_C2", n_sym, flat(target.root, n_sym)}};
}

template <int Dim>
std::vector<CellField> cell_fields(const Octree<Dim>& grid, const std::vector<Vec<Dim>>& phi,
                                   const std::vector<double>& distance1, double sigma) {
  const auto leaves = grid.leaves();
  CellField band{"in_band", std::vector<double>(leaves.size())};
  CellField determinant{"min_determinant", std::vector<double>(leaves.size())};
  std::vector<Element<Dim>> elements(leaves.size());
  parallel_for(leaves.size(), [&](std::size_t i) {
    const auto& cell = grid.cell(leaves[i]);
    double low = distance1[cell.nodes[0]], high = low;
    for (const Index n : cell.nodes) {
      low = std::min(low, distance1[n]);
      high = std::max(high, distance1[n]);
    }
    band.values[i] = low < sigma && high > -sigma;
    elements[i] = {cell.nodes, cell.side()};
  });
  const auto bounds = determinant_bounds<Dim>(elements, phi);
  for (std::size_t i = 0; i < bounds.size(); ++i) determinant.values[i] = bounds[i].bound;
  return {std::move(band), std::move(determinant)};
}

SHELLMATCH_2D_3D(nodal_fields);
SHELLMATCH_2D_3D(cell_fields);

}  // namespace shellmatch
