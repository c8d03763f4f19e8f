#include "apps/cohorts/output/mode_animations.h"

#include "base/replace_file.h"
#include "apps/cohorts/output/model_files.h"
#include "apps/cohorts/report/shape_drawer.h"
#include "matching/render/canvas/animation.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace shellmatch {

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

template void write_mode_animations<2>(const CohortResult<2>&, int, const std::string&);
template void write_mode_animations<3>(const CohortResult<3>&, int, const std::string&);

}  // namespace shellmatch
