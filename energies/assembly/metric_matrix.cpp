#include "energies/assembly/metric_matrix.h"

#include "grid/fields/mass.h"

#include <cmath>
#include <variant>

namespace shellmatch {

namespace {

using Sparse = Eigen::SparseMatrix<double>;
using Triplets = std::vector<Eigen::Triplet<double>>;

template <int Dim>
using ElementMatrix = Eigen::Matrix<double, n_corners<Dim>, n_corners<Dim>>;

// Factor of the match term's second derivative in the mass. The matrix is scalar, so factor 1 would weigh tangential
// displacements like normal ones, although the term depends on the normal ones alone. Final energies of a pair of
// leaves in the plane (levels 4 to 6, lbfgs): 0.2393 with factor 0.1, 0.2432 with 1, 0.3590 with 0, 0.2398 with the
// metric l2.
constexpr double match_factor = 0.1;

/// Adds the integrand mass * u v + stiffness * Du.Dv at one quadrature point of an element of side `side`, for all
/// pairs of shape functions.
template <int Dim>
ElementMatrix<Dim> at_point(const typename ShapeTable<Dim>::Point& q, double mass, double stiffness, double side) {
  ElementMatrix<Dim> m;
  for (int c = 0; c < n_corners<Dim>; ++c)
    for (int d = 0; d < n_corners<Dim>; ++d) {
      double product = 0;
      for (int k = 0; k < Dim; ++k) product += q.dn[c][k] * q.dn[d][k];
      m(c, d) = mass * q.n[c] * q.n[d] + stiffness * product / (side * side);
    }
  return m;
}

template <int Dim>
void add(const Element<Dim>& element, const ElementMatrix<Dim>& m, Triplets& to) {
  for (int c = 0; c < n_corners<Dim>; ++c)
    for (int d = 0; d < n_corners<Dim>; ++d) to.emplace_back(element.nodes[c], element.nodes[d], m(c, d));
}

/// The constraint matrix C of x = C x_unknown. Rows: nodes of the grid; columns: unknown nodes.
template <int Dim>
Sparse constraint_matrix(const Octree<Dim>& grid, const Unknowns<Dim>& unknowns) {
  Triplets entries;
  for (Index node = 0; node < grid.n_nodes(); ++node)
    for (const ConstraintEntry& entry : unknowns.constraint_entries(node))
      entries.emplace_back(node, entry.unknown, static_cast<double>(entry.weight));
  Sparse c(grid.n_nodes(), static_cast<Index>(unknowns.nodes().size()));
  c.setFromTriplets(entries.begin(), entries.end());
  return c;
}

}  // namespace

template <int Dim>
MetricWeights stiffness_of_energy(const EnergyTerms<Dim>& terms, const TermValues& weights) {
  MetricWeights sums{.mass = 0};
  for (std::size_t t = 0; t < terms.size(); ++t) {
    const CompiledTerm<Dim>& term = terms[t].term;
    const Material<double>& material = terms[t].material;
    if (const auto* band = std::get_if<BandCode<Dim>>(&term.code)) {
      const double stiffness = weights[t] * term.modulus(material);
      if (band->reads_dphi) sums.band_stiffness += stiffness;
      else sums.band_mass += match_factor * stiffness / Dim;
    } else if (const auto* cells = std::get_if<CellCode<Dim>>(&term.code)) {
      sums.mass += cells->reads_dphi ? weights[t] : weights[t] * term.modulus(material);
      if (cells->reads_dphi) sums.stiffness += weights[t] * term.modulus(material);
    }
  }
  return sums;
}

template <int Dim>
Eigen::SparseMatrix<double> metric_matrix(const Octree<Dim>& grid, const Unknowns<Dim>& unknowns,
                                          const MatchingEnergy<Dim>& energy, const MetricWeights& weights) {
  const auto elements = unknowns.elements();
  Triplets entries;
  if (weights.stiffness > 0) {
    ElementMatrix<Dim> unit = ElementMatrix<Dim>::Zero();  // stiffness matrix of the unit cell
    for (const auto& q : ShapeTable<Dim>(2).points) unit += at_point<Dim>(q, 0, q.weight, 1);
    for (const Element<Dim>& e : elements) add<Dim>(e, weights.stiffness * std::pow(e.side, Dim - 2) * unit, entries);
  }
  if (weights.band_mass > 0 || weights.band_stiffness > 0) {
    const Band<Dim>& band = energy.band();
    const auto& points = energy.shape().points;
    for (std::size_t b = 0; b < band.batches().size(); ++b)
      for (int lane = 0; lane < band.batches()[b].n_elements; ++lane) {
        const Element<Dim>& e = elements[band.batches()[b].element[lane]];
        ElementMatrix<Dim> m = ElementMatrix<Dim>::Zero();
        for (std::size_t q = 0; q < points.size(); ++q)
          if (const double w = band.point(b, q).weight[lane]; w > 0)
            m += at_point<Dim>(points[q], w * weights.band_mass, w * weights.band_stiffness, e.side);
        add<Dim>(e, m, entries);
      }
  }
  Sparse nodal(grid.n_nodes(), grid.n_nodes());
  nodal.setFromTriplets(entries.begin(), entries.end());
  const Sparse c = constraint_matrix(grid, unknowns);
  Sparse matrix = Sparse(c.transpose()) * nodal * c;

  const std::vector<double> mass = lumped_mass(grid);
  Sparse diagonal(matrix.rows(), matrix.cols());
  diagonal.reserve(Eigen::VectorXi::Constant(matrix.cols(), 1));
  for (Index i = 0; i < matrix.cols(); ++i)
    diagonal.insert(i, i) = weights.mass * mass[grid.free_index(unknowns.nodes()[i])];
  matrix += diagonal;
  matrix.makeCompressed();
  return matrix;
}

SHELLMATCH_2D_3D(stiffness_of_energy);
SHELLMATCH_2D_3D(metric_matrix);

}  // namespace shellmatch
