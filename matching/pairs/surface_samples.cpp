#include "matching/pairs/surface_samples.h"

#include "geometry/surface/morton_curve.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace shellmatch {

template <int Dim>
std::vector<SurfaceSample<Dim>> sample_vertices(const Surface<Dim>& surface, std::size_t most,
                                                const std::function<bool(const Vec<Dim>&)>& contains) {
  const auto n = static_cast<Index>(surface.vertices.size());
  const std::vector<Vec<Dim>> normals = vertex_normals(surface);
  const std::vector<double> area = vertex_measures(surface);
  std::vector<Index> order;
  double total = 0;
  for (Index v = 0; v < n; ++v)
    if (area[v] > 0 && !normals[v].isZero(0) && contains(surface.vertices[v])) {
      order.push_back(v);
      total += area[v];
    }
  std::vector<SurfaceSample<Dim>> samples;
  if (order.size() <= most) {
    for (const Index v : order) samples.push_back({v, surface.vertices[v], normals[v], area[v]});
    return samples;
  }
  std::vector<std::uint64_t> number(surface.vertices.size());
  for (const Index v : order) number[v] = morton_number<Dim>(surface.vertices[v]);
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return number[a] < number[b]; });
  const double each = total / static_cast<double>(most);
  double passed = 0, next = 0.5 * each;
  for (const Index v : order) {
    passed += area[v];
    if (passed < next) continue;
    const double count = std::floor((passed - next) / each) + 1;  // a vertex may stand for several shares
    samples.push_back({v, surface.vertices[v], normals[v], count * each});
    next += count * each;
  }
  return samples;
}

template std::vector<SurfaceSample<2>> sample_vertices(const Surface<2>&, std::size_t,
                                                       const std::function<bool(const Vec<2>&)>&);
template std::vector<SurfaceSample<3>> sample_vertices(const Surface<3>&, std::size_t,
                                                       const std::function<bool(const Vec<3>&)>&);

}  // namespace shellmatch
