#include "apps/cohorts/report/point_values.h"

#include "apps/cohorts/report/shown_shapes.h"

#include <cmath>
#include <limits>

namespace shellmatch {

namespace {

// Sums of the facets' normals, weighted by their measure, as unit vectors; zero where they cancel.
template <int Dim>
std::vector<Vec<Dim>> outward_normals(const Surface<Dim>& surface) {
  std::vector<Vec<Dim>> normals(surface.vertices.size(), Vec<Dim>::Zero());
  const double sign = enclosed_measure<Dim>(surface) < 0 ? -1 : 1;
  for (std::size_t f = 0; f < surface.facets.size(); ++f) {
    const Vec<Dim> normal = sign * facet_normal(surface, static_cast<Index>(f));
    for (const Index v : surface.facets[f]) normals[static_cast<std::size_t>(v)] += normal;
  }
  for (Vec<Dim>& n : normals) n = n.norm() > 0 ? Vec<Dim>(n.normalized()) : Vec<Dim>(Vec<Dim>::Zero());
  return normals;
}

}  // namespace

template <int Dim>
CohortPointValues cohort_point_values(const CohortResult<Dim>& result, const Surface<Dim>& mean) {
  CohortPointValues values;
  const Eigen::MatrixXd& shapes = result.aligned.coordinates;
  if (shapes.cols() > 1) {
    Eigen::VectorXd centre(shapes.rows());
    for (std::size_t v = 0; v < mean.vertices.size(); ++v)
      centre.segment<Dim>(static_cast<Eigen::Index>(Dim * v)) = mean.vertices[v];
    const Eigen::VectorXd squares =
        (shapes.colwise() - centre).rowwise().squaredNorm() / static_cast<double>(shapes.cols() - 1);
    for (const Vec<Dim>& of_axes : points_of<Dim>(squares)) values.deviation.push_back(std::sqrt(of_axes.sum()));
  }
  if (result.difference) {
    const std::vector<Vec<Dim>> differences = points_of<Dim>(result.difference->difference),
                                normals = outward_normals(mean);
    for (std::size_t v = 0; v < differences.size(); ++v) {
      values.difference.push_back(differences[v].norm());
      const bool has_normal = !normals[v].isZero();
      values.difference_normal.push_back(has_normal ? differences[v].dot(normals[v])
                                                    : std::numeric_limits<double>::quiet_NaN());
    }
  }
  return values;
}

template CohortPointValues cohort_point_values<2>(const CohortResult<2>&, const Surface<2>&);
template CohortPointValues cohort_point_values<3>(const CohortResult<3>&, const Surface<3>&);

}  // namespace shellmatch
