#include "alignment/spectrum/limb_ends.h"

#include "alignment/spectrum/prepared_surface.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace shellmatch {

LimbEnds limb_ends(const Surface<3>& surface, const AlignmentOptions& options) {
  PreparedSurface prepared = prepare_surface(surface, options);
  std::vector<Vec<3>> vertices = prepared.surface.vertices;
  const double root_area = std::sqrt(surface_measure(prepared.surface));
  for (Vec<3>& x : prepared.surface.vertices) x /= root_area;
  const EdgeGraph graph(prepared.surface);
  const std::vector<Index> samples = farthest_point_samples(graph, 0, n_tip_samples);
  return {std::move(vertices), surface_tips(graph, samples), prepared.share};
}

double limb_disorder(const LimbEnds& reference, const std::vector<Vec<3>>& images, const LimbEnds& template_shape,
                     const std::vector<Vec<3>>& places) {
  const auto nearest = [](const std::vector<SurfaceTip>& tips, const std::vector<Vec<3>>& of_tips,
                          const std::vector<Vec<3>>& others) {
    std::vector<Index> found;
    for (const SurfaceTip& tip : tips) {
      const Vec<3>& x = of_tips[tip.vertex];
      const auto at = std::ranges::min_element(others, {}, [&](const Vec<3>& y) { return (x - y).squaredNorm(); });
      found.push_back(static_cast<Index>(at - others.begin()));
    }
    return found;
  };
  return tip_disorder(reference.tips, nearest(reference.tips, images, places), template_shape.tips,
                      nearest(template_shape.tips, places, images));
}

}  // namespace shellmatch
