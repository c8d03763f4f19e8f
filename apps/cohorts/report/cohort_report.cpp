#include "apps/cohorts/report/cohort_report.h"

#include "apps/cohorts/report/cohort_description.h"
#include "apps/cohorts/report/cohort_page.h"
#include "apps/cohorts/report/shown_shapes.h"
#include "apps/cohorts/report/worst_first.h"
#include "matching/report/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

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

namespace {

constexpr Eigen::Index most_modes = 12;
constexpr std::size_t most_thumbnails = 200;

// Modes as displacements by one standard deviation of their score, and scores row after row in these standard
// deviations.
template <int Dim>
Eigen::Index add_modes(PackedArrays& arrays, const ShapeModel& model) {
  const Eigen::Index n_modes = std::min(most_modes, model.modes.cols());
  for (Eigen::Index k = 0; k < n_modes; ++k)
    arrays.add_points<Dim>(fmt::format("mode.{}", k + 1),
                           points_of<Dim>(std::sqrt(model.variances[k]) * model.modes.col(k)));
  std::vector<double> scores;
  for (Eigen::Index i = 0; i < model.scores.rows(); ++i)
    for (Eigen::Index k = 0; k < n_modes; ++k) scores.push_back(model.scores(i, k) / std::sqrt(model.variances[k]));
  arrays.add_numbers("scores", scores);
  return n_modes;
}

// All shapes of the cohort, and what the slider of the first mode reaches.
PageView view_of(const CohortResult<3>& result, const Surface<3>& mean) {
  std::vector<Surface<3>> all = extents(result, mean);
  if (result.model && result.model->modes.cols() > 0)
    for (const double b : {-3.0, 3.0}) {
      const Eigen::VectorXd moved =
          result.model->mean + b * std::sqrt(result.model->variances[0]) * result.model->modes.col(0);
      all.push_back({points_of<3>(moved), {}});
    }
  std::vector<const Surface<3>*> pointers;
  for (const Surface<3>& s : all) pointers.push_back(&s);
  return page_view(pointers);
}

}  // namespace

template <int Dim>
std::string cohort_report_html(const CohortResult<Dim>& result) {
  CohortFrame frame;
  frame.order = worst_first(result.subjects);
  auto [mean, kind] = central_shape(result);
  frame.shape = std::move(kind);
  frame.thumbnails = subject_thumbnails(result, mean, frame.order, most_thumbnails);
  PackedArrays arrays;
  arrays.add_points<Dim>("mean", mean.vertices);
  std::vector<Index> corners;
  for (const auto& facet : mean.facets) corners.insert(corners.end(), facet.begin(), facet.end());
  arrays.add_indices("facets", Dim, corners);
  if (result.model) frame.n_modes = add_modes<Dim>(arrays, *result.model);
  const CohortPointValues values = cohort_point_values(result, mean);
  if (!values.deviation.empty()) arrays.add_numbers("deviation", values.deviation);
  if (result.difference) {
    arrays.add_numbers("difference", values.difference);
    arrays.add_numbers("difference_normal", values.difference_normal);
    const Eigen::VectorXd& p = result.difference->p_corrected;
    arrays.add_numbers("p_corrected", {p.data(), static_cast<std::size_t>(p.size())});
  }
  if constexpr (Dim == 3) frame.view = view_of(result, mean);
  return filled_page(cohort_page, cohort_json(result, frame, arrays.arrays()), base64(arrays.compressed()));
}

SHELLMATCH_2D_3D(cohort_point_values);
SHELLMATCH_2D_3D(cohort_report_html);

}  // namespace shellmatch
