#include "matching/pairs/surface_samples.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace shellmatch {

namespace {

/// Number along a Morton curve: points that are close on the curve are close in space.
template <int Dim>
std::uint64_t morton_number(const Vec<Dim>& x) {
  std::uint64_t number = 0;
  constexpr int bits = 60 / Dim;
  for (int k = 0; k < Dim; ++k) {
    const auto coordinate = static_cast<std::uint64_t>(std::clamp(x[k], 0.0, 1.0) * ((std::uint64_t{1} << bits) - 1));
    for (int bit = 0; bit < bits; ++bit) number |= ((coordinate >> bit) & 1) << (bit * Dim + k);
  }
  return number;
}

}  // namespace

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
