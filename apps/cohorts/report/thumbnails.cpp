#include "apps/cohorts/report/thumbnails.h"

#include "apps/cohorts/report/shape_drawer.h"
#include "apps/cohorts/report/shown_shapes.h"
#include "matching/render/canvas/canvas.h"

#include <algorithm>
#include <cmath>

namespace shellmatch {

namespace {

constexpr int picture_size = 176;  // pixels; the page shows them half as large, for dense screens

std::string png_of(const Image& image) {
  Canvas canvas(image.width, image.height);
  canvas.image(image, 0, 0);
  return canvas.bytes();
}

template <int Dim>
std::vector<double> distances_between(const std::vector<Vec<Dim>>& a, const std::vector<Vec<Dim>>& b) {
  std::vector<double> distances;
  distances.reserve(a.size());
  for (std::size_t v = 0; v < a.size(); ++v) distances.push_back((a[v] - b[v]).norm());
  return distances;
}

double quantile_98(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(0.98 * static_cast<double>(values.size() - 1));
  std::ranges::nth_element(values, place);
  return *place;
}

}  // namespace

template <int Dim>
SubjectThumbnails subject_thumbnails(const CohortResult<Dim>& result, const Surface<Dim>& mean,
                                     const std::vector<std::size_t>& order, std::size_t most) {
  SubjectThumbnails thumbnails;
  thumbnails.pictures.resize(result.subjects.size());
  std::vector<std::pair<std::size_t, Eigen::Index>> drawn;  // subjects and their columns
  for (const std::size_t subject : order) {
    const auto row = std::ranges::find(result.rows, subject);
    if (row == result.rows.end()) continue;
    if (drawn.size() < most) drawn.emplace_back(subject, row - result.rows.begin());
    else ++thumbnails.n_left_out;
  }
  if (drawn.empty()) return thumbnails;
  const auto points = [&](Eigen::Index column) { return points_of<Dim>(result.aligned.coordinates.col(column)); };
  std::vector<double> all_distances;
  for (const auto& [subject, column] : drawn) {
    const std::vector<double> distances = distances_between<Dim>(points(column), mean.vertices);
    all_distances.insert(all_distances.end(), distances.begin(), distances.end());
  }
  thumbnails.scale_end = quantile_98(std::move(all_distances));
  const std::vector<Surface<Dim>> reaching = extents(result, mean);
  std::vector<const Surface<Dim>*> all;
  for (const Surface<Dim>& s : reaching) all.push_back(&s);
  const ShapeDrawer<Dim> drawer(all, picture_size);
  for (const auto& [subject, column] : drawn) {
    const Surface<Dim> shape{points(column), mean.facets};
    const std::vector<double> distances = distances_between<Dim>(shape.vertices, mean.vertices);
    thumbnails.pictures[subject] = png_of(drawer.draw(shape, distances, thumbnails.scale_end));
  }
  return thumbnails;
}

#define SHELLMATCH_INSTANTIATE(Dim)                                                                 \
  template SubjectThumbnails subject_thumbnails<Dim>(const CohortResult<Dim>&, const Surface<Dim>&, \
                                                     const std::vector<std::size_t>&, std::size_t)
SHELLMATCH_INSTANTIATE(2);
SHELLMATCH_INSTANTIATE(3);
#undef SHELLMATCH_INSTANTIATE

}  // namespace shellmatch
