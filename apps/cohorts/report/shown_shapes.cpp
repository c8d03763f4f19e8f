#include "apps/cohorts/report/shown_shapes.h"

#include "base/error.h"
#include "matching/render/canvas/canvas.h"
#include "matching/render/surfaces/surfaces.h"

#include <algorithm>
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

template <>
ShapeDrawer<3>::ShapeDrawer(std::span<const Surface<3>* const> all, int size)
    : view_(fit_camera(all, 1, {.margin = 0.03})), size_(size) {}

template <>
ShapeDrawer<2>::ShapeDrawer(std::span<const Surface<2>* const> all, int size) : view_(fit_frame(all)), size_(size) {}

template <>
Image ShapeDrawer<3>::draw(const Surface<3>& shape, const std::vector<double>& values, double scale_end) const {
  RenderSurface look{.surface = &shape};
  if (scale_end > 0) {
    look.paint = Paint::scalar;
    look.scalars = values;
    look.scalar_max = scale_end;
  }
  return render_surfaces({&look, 1}, view_,
                         {.width = size_, .height = size_, .samples = 3, .ambient_occlusion = false});
}

template <>
Image ShapeDrawer<2>::draw(const Surface<2>& shape, const std::vector<double>& values, double scale_end) const {
  RenderContour look{.contour = &shape, .fill_alpha = 0.6, .line_width = size_ / 50.0};
  if (scale_end > 0)
    for (const double d : values) look.vertex_colors.push_back(map_color(ColorMap::sequential, d / scale_end));
  return render_contours({&look, 1}, view_, size_, size_);
}

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

SHELLMATCH_2D_3D(central_shape);
SHELLMATCH_2D_3D(extents);
SHELLMATCH_2D_3D(subject_thumbnails);

}  // namespace shellmatch
