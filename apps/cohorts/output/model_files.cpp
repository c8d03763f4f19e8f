#include "apps/cohorts/output/model_files.h"

#include "apps/cohorts/output/npy_file.h"
#include "apps/cohorts/report/shown_shapes.h"
#include "base/replace_file.h"
#include "base/text.h"
#include "geometry/io/write_shape.h"
#include "geometry/outline/tps_file.h"
#include "matching/render/canvas/animation.h"
#include "matching/result/deformed_shape.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <numbers>
#include <span>

namespace shellmatch {

namespace {

namespace fs = std::filesystem;

std::span<const double> values_of(const Eigen::MatrixXd& matrix) {
  return {matrix.data(), static_cast<std::size_t>(matrix.size())};
}

template <int Dim>
void write_points(const std::string& path, const Eigen::MatrixXd& columns) {
  const auto n = static_cast<std::size_t>(columns.cols()), n_points = static_cast<std::size_t>(columns.rows() / Dim);
  write_npy(path, {n, n_points, Dim}, values_of(columns));
}

// The same as text, subject by subject, for programs that read no arrays; very many points are left to points.npy.
constexpr Eigen::Index most_points_of_text = 5'000'000;

template <int Dim>
void write_points_as_text(const std::string& name, const CohortResult<Dim>& result, const Eigen::MatrixXd& columns) {
  if (columns.size() / Dim > most_points_of_text) {
    for (const char* ending : {".csv", ".tps"}) fs::remove(name + ending);  // of an earlier run
    return;
  }
  std::string csv = Dim == 3 ? "id,point,x,y,z\n" : "id,point,x,y\n", tps;
  for (Eigen::Index k = 0; k < columns.cols(); ++k) {
    const std::string& id = result.subjects[result.rows[static_cast<std::size_t>(k)]].id;
    const Eigen::VectorXd column = columns.col(k);
    const std::span<const double> points(column.data(), static_cast<std::size_t>(column.size()));
    const std::string first = csv_field(id);
    for (std::size_t p = 0; p < points.size() / Dim; ++p)
      fmt::format_to(std::back_inserter(csv), "{},{},{}\n", first, p, fmt::join(points.subspan(Dim * p, Dim), ","));
    append_tps_specimen(tps, id, points, Dim);
  }
  replace_file(name + ".csv", csv);
  replace_file(name + ".tps", tps);
}

template <int Dim>
OriginalShape<Dim> with_points(OriginalShape<Dim> shape, const Eigen::VectorXd& points) {
  Eigen::Index p = 0;
  for (Vec<Dim>& x : shape.vertices) x = points.segment<Dim>(Dim * p++);
  return shape;
}

template <int Dim>
void write_shape_file(const std::string& name, const OriginalShape<Dim>& shape) {
  if constexpr (Dim == 3) write_ply(name + ".ply", shape);
  else write_outline_csv(name + ".csv", shape);
}

std::vector<double> list_of(const Eigen::VectorXd& values) { return {values.data(), values.data() + values.size()}; }

// The standard deviation of each point: the root of the mean square distance from the mean.
template <int Dim>
std::vector<double> deviations(const PointSets& aligned, const Eigen::VectorXd& mean) {
  std::vector<double> result(static_cast<std::size_t>(aligned.n_points()));
  for (Eigen::Index p = 0; p < aligned.n_points(); ++p) {
    double sum = 0;
    for (Eigen::Index k = 0; k < aligned.n_sets(); ++k)
      sum += (aligned.coordinates.col(k).segment<Dim>(Dim * p) - mean.segment<Dim>(Dim * p)).squaredNorm();
    result[static_cast<std::size_t>(p)] = std::sqrt(sum / static_cast<double>(aligned.n_sets() - 1));
  }
  return result;
}

template <int Dim>
void add_difference(OriginalShape<Dim>& mean, const GroupDifference& d) {
  constexpr const char* axes[] = {"x", "y", "z"};
  std::vector<double> length(mean.vertices.size());
  for (std::size_t v = 0; v < length.size(); ++v)
    length[v] = d.difference.segment<Dim>(Dim * static_cast<Eigen::Index>(v)).norm();
  set_attribute(mean, VertexAttribute{"difference", "double", length});
  for (int k = 0; k < Dim; ++k) {
    std::vector<double> component(length.size());
    for (std::size_t v = 0; v < length.size(); ++v) component[v] = d.difference[Dim * static_cast<Eigen::Index>(v) + k];
    set_attribute(mean, VertexAttribute{fmt::format("difference_{}", axes[k]), "double", std::move(component)});
  }
  set_attribute(mean, VertexAttribute{"t2", "double", list_of(d.statistic)});
  set_attribute(mean, VertexAttribute{"p", "double", list_of(d.p)});
  set_attribute(mean, VertexAttribute{"p_corrected", "double", list_of(d.p_corrected)});
  set_attribute(mean, VertexAttribute{"q", "double", list_of(d.q)});
}

}  // namespace

template <int Dim>
void write_model(const CohortResult<Dim>& result, const Eigen::MatrixXd& points, int n_mode_meshes,
                 const std::string& folder) {
  fs::create_directories(folder);
  write_points<Dim>(folder + "/points.npy", points);
  write_points_as_text(folder + "/points", result, points);
  write_points<Dim>(folder + "/aligned.npy", result.aligned.coordinates);
  std::vector<std::int32_t> faces;
  for (const auto& facet : result.surface.facets)
    for (const Index v : facet) faces.push_back(static_cast<std::int32_t>(v));
  write_npy(folder + "/faces.npy", {result.surface.facets.size(), Dim}, faces);
  if (!result.model) return;
  const ShapeModel& model = *result.model;
  write_points<Dim>(folder + "/modes.npy", model.modes);
  OriginalShape<Dim> mean = with_points(result.atlas, model.mean);
  for (Eigen::Index k = 0; k < std::min<Eigen::Index>(n_mode_meshes, model.variances.size()); ++k)
    for (const double sign : {-1., 1.}) {
      const double score = sign * mode_deviations * std::sqrt(model.variances[k]);
      write_shape_file<Dim>(fmt::format("{}/mode_{}_{}", folder, k + 1, sign < 0 ? "minus" : "plus"),
                            with_points(result.atlas, model.mean + score * model.modes.col(k)));
    }
  set_attribute(mean, VertexAttribute{"standard_deviation", "double", deviations<Dim>(result.aligned, model.mean)});
  if (result.difference) add_difference(mean, *result.difference);
  write_shape_file<Dim>(folder + "/mean", mean);
  if constexpr (Dim == 3) write_shape(folder + "/mean.vtp", mean);
}

namespace {

constexpr int frame_size = 320, n_frames = 32, frame_quality = 80;
constexpr double swing_seconds = 2.4;

template <int Dim>
Surface<Dim> moved(const Surface<Dim>& atlas, const Eigen::VectorXd& points) {
  Surface<Dim> surface{atlas.vertices, atlas.facets};
  Eigen::Index p = 0;
  for (Vec<Dim>& x : surface.vertices) x = points.segment<Dim>(Dim * p++);
  return surface;
}

}  // namespace

template <int Dim>
void write_mode_animations(const CohortResult<Dim>& result, int n_modes, const std::string& folder) {
  const ShapeModel& model = *result.model;
  for (Eigen::Index k = 0; k < std::min<Eigen::Index>(n_modes, model.variances.size()); ++k) {
    const double far = mode_deviations * std::sqrt(model.variances[k]);
    const auto at = [&](double score) { return moved<Dim>(result.surface, model.mean + score * model.modes.col(k)); };
    const std::array<Surface<Dim>, 2> ends = {at(-far), at(far)};
    const std::array<const Surface<Dim>*, 2> both = {&ends[0], &ends[1]};
    const ShapeDrawer<Dim> drawer(both, frame_size);
    // How far each vertex moves at one unit of the score.
    std::vector<double> speed(result.surface.vertices.size());
    for (std::size_t v = 0; v < speed.size(); ++v)
      speed[v] = model.modes.col(k).segment<Dim>(Dim * static_cast<Eigen::Index>(v)).norm();
    const double scale_end = far * *std::ranges::max_element(speed);
    Animation animation(frame_quality);
    for (int frame = 0; frame < n_frames; ++frame) {
      const double score = far * std::sin(2 * std::numbers::pi * frame / n_frames);
      std::vector<double> distance = speed;
      for (double& d : distance) d *= std::abs(score);
      animation.add(drawer.draw(at(score), distance, scale_end), swing_seconds / n_frames);
    }
    replace_file(fmt::format("{}/mode_{}.webp", folder, k + 1), animation.bytes());
  }
}

SHELLMATCH_2D_3D(write_model);
SHELLMATCH_2D_3D(write_mode_animations);

}  // namespace shellmatch
