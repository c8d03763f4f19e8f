#include "matching/render/surfaces/corner_normals.h"

#include "base/parallel.h"

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

namespace shellmatch {

namespace {

// Normals whose length is twice the area of the facet.
std::vector<Vec<3>> facet_normals(const Surface<3>& surface) {
  std::vector<Vec<3>> normals(surface.facets.size());
  parallel_for(normals.size(), [&](std::size_t f) { normals[f] = facet_normal(surface, static_cast<Index>(f)); });
  return normals;
}

}  // namespace

std::vector<std::array<Vec<3>, 3>> corner_normals(const Surface<3>& surface, double crease_angle) {
  const std::vector<Vec<3>> facet = facet_normals(surface);
  // The facets at vertex v are around[first[v]] to around[first[v + 1] - 1].
  std::vector<std::size_t> first(surface.vertices.size() + 1, 0);
  for (const auto& corners : surface.facets)
    for (const Index v : corners) ++first[v + 1];
  for (std::size_t v = 0; v + 1 < first.size(); ++v) first[v + 1] += first[v];
  std::vector<std::size_t> around(first.back()), next(first.begin(), first.end() - 1);
  for (std::size_t f = 0; f < surface.facets.size(); ++f)
    for (const Index v : surface.facets[f]) around[next[v]++] = f;

  const double least = std::cos(crease_angle * std::numbers::pi / 180);
  std::vector<std::array<Vec<3>, 3>> normals(surface.facets.size());
  parallel_for(normals.size(), [&](std::size_t f) {
    const Vec<3> own = facet[f].normalized();
    for (int k = 0; k < 3; ++k) {
      const Index v = surface.facets[f][k];
      Vec<3> sum = facet[f];
      for (std::size_t i = first[v]; i < first[v + 1]; ++i)
        if (const Vec<3>& n = facet[around[i]]; around[i] != f && n.dot(own) > least * n.norm()) sum += n;
      normals[f][k] = sum.normalized();
    }
  });
  return normals;
}

}  // namespace shellmatch
