#include "apps/cohorts/report/shown_shapes.h"

#include "base/error.h"

#include <utility>

namespace shellmatch {

template <int Dim>
CentralShape<Dim> central_shape(const CohortResult<Dim>& result) {
  const Eigen::MatrixXd& shapes = result.aligned.coordinates;
  SHELLMATCH_CHECK(shapes.cols() == static_cast<Eigen::Index>(result.rows.size()),
                   "each column of a cohort's statistics is a subject");
  if (shapes.cols() == 0) return {{result.atlas.vertices, result.surface.facets}, "atlas"};
  SHELLMATCH_CHECK(shapes.rows() == Dim * static_cast<Eigen::Index>(result.atlas.vertices.size()),
                   "a shape of a cohort has the points of the atlas");
  const Eigen::VectorXd centre = result.model ? result.model->mean : Eigen::VectorXd(shapes.rowwise().mean());
  return {{points_of<Dim>(centre), result.surface.facets}, shapes.cols() == 1 ? "subject" : "mean"};
}

template <int Dim>
std::vector<Surface<Dim>> extents(const CohortResult<Dim>& result, const Surface<Dim>& surface) {
  constexpr std::size_t most_points = 1000;  // of each shape; the margins are wider than what these leave out
  std::vector<Surface<Dim>> all = {surface};
  const std::size_t stride = 1 + surface.vertices.size() / most_points;
  for (Eigen::Index c = 0; c < result.aligned.coordinates.cols(); ++c) {
    Surface<Dim> few;
    const auto column = result.aligned.coordinates.col(c);
    for (std::size_t v = 0; v < surface.vertices.size(); v += stride)
      few.vertices.push_back(column.template segment<Dim>(static_cast<Eigen::Index>(Dim * v)));
    all.push_back(std::move(few));
  }
  return all;
}

#define SHELLMATCH_INSTANTIATE(Dim)                                        \
  template CentralShape<Dim> central_shape<Dim>(const CohortResult<Dim>&); \
  template std::vector<Surface<Dim>> extents<Dim>(const CohortResult<Dim>&, const Surface<Dim>&)
SHELLMATCH_INSTANTIATE(2);
SHELLMATCH_INSTANTIATE(3);
#undef SHELLMATCH_INSTANTIATE

}  // namespace shellmatch
