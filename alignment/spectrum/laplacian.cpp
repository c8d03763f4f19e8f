#include "alignment/spectrum/laplacian.h"

#include <algorithm>
#include <cmath>

namespace shellmatch {

namespace {

/// Area of a triangle of three lengths, exact to rounding also for slivers: W. Kahan, 'Miscalculating area and angles
/// of a needle-like triangle', 2014.
double triangle_area(Vec<3> lengths) {
  std::sort(lengths.data(), lengths.data() + 3);
  const double c = lengths[0], b = lengths[1], a = lengths[2];
  return 0.25 * std::sqrt(std::max(0.0, (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c))));
}

}  // namespace

std::vector<Vec<3>> mollified_edge_lengths(const Surface<3>& surface, double mollification) {
  std::vector<Vec<3>> lengths(surface.facets.size());
  double sum = 0;
  for (std::size_t f = 0; f < lengths.size(); ++f) {
    const auto& corners = surface.facets[f];
    for (int k = 0; k < 3; ++k)
      lengths[f][k] = (surface.vertices[corners[(k + 1) % 3]] - surface.vertices[corners[(k + 2) % 3]]).norm();
    sum += lengths[f].sum();
  }
  const double least = mollification * sum / (3 * static_cast<double>(std::max<std::size_t>(1, lengths.size())));
  for (Vec<3>& l : lengths) l.array() += std::max(0.0, least - (l.sum() - 2 * l.maxCoeff()));
  return lengths;
}

SurfaceLaplacian surface_laplacian(const Surface<3>& surface, double mollification) {
  const std::vector<Vec<3>> lengths = mollified_edge_lengths(surface, mollification);
  const auto n = static_cast<Eigen::Index>(surface.vertices.size());
  SurfaceLaplacian laplacian{Eigen::SparseMatrix<double>(n, n), Eigen::VectorXd::Zero(n)};
  std::vector<Eigen::Triplet<double, int>> entries;
  entries.reserve(12 * lengths.size());
  for (std::size_t f = 0; f < lengths.size(); ++f) {
    const double area = triangle_area(lengths[f]);
    const Vec<3> squares = lengths[f].cwiseAbs2();
    for (int k = 0; k < 3; ++k) {
      const Index i = surface.facets[f][(k + 1) % 3], j = surface.facets[f][(k + 2) % 3];
      laplacian.mass[surface.facets[f][k]] += area / 3;
      // Half of the cotangent of the angle at corner k.
      const double weight = (squares.sum() - 2 * squares[k]) / (8 * area);
      entries.emplace_back(i, j, -weight);
      entries.emplace_back(j, i, -weight);
      entries.emplace_back(i, i, weight);
      entries.emplace_back(j, j, weight);
    }
  }
  laplacian.stiffness.setFromTriplets(entries.begin(), entries.end());
  return laplacian;
}

}  // namespace shellmatch
