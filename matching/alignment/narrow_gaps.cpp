#include "matching/alignment/narrow_gaps.h"

#include "base/parallel.h"
#include "geometry/surface/surface.h"

#include <vector>

namespace shellmatch {

namespace {

// Above a plane the distance is the height; above a gently hollow place it is a little less.
constexpr double near_enough = 0.7;
// A share needs no more of them; the others are left out evenly.
constexpr std::size_t most_facets = 20000;

}  // namespace

template <int Dim>
double narrow_gap_share(const SignedDistance<Dim>& shape, double height) {
  const Surface<Dim>& surface = shape.surface();
  const std::size_t step = 1 + surface.facets.size() / most_facets;
  std::vector<double> area((surface.facets.size() + step - 1) / step);
  std::vector<char> is_narrow(area.size());
  parallel_for(area.size(), [&](std::size_t i) {
    const auto f = static_cast<Index>(i * step);
    area[i] = facet_measure(surface, f);
    if (!(area[i] > 0)) return;
    Vec<Dim> centre = Vec<Dim>::Zero();
    for (const Index v : surface.facets[i * step]) centre += surface.vertices[static_cast<std::size_t>(v)] / Dim;
    is_narrow[i] = shape(centre + height * facet_normal(surface, f).normalized()) < near_enough * height;
  });
  double narrow = 0, all = 0;
  for (std::size_t i = 0; i < area.size(); ++i) {
    all += area[i];
    if (is_narrow[i]) narrow += area[i];
  }
  return all > 0 ? narrow / all : 0;
}

template double narrow_gap_share<2>(const SignedDistance<2>&, double);
template double narrow_gap_share<3>(const SignedDistance<3>&, double);

}  // namespace shellmatch
