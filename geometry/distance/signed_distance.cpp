#include "geometry/distance/signed_distance.h"

#include "base/error.h"
#include "geometry/surface/facet_point.h"
#include "geometry/distance/facet_tree.h"
#include "geometry/distance/winding_number.h"
#include "geometry/surface/pseudonormals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace shellmatch {

template <int Dim>
struct SignedDistance<Dim>::Tree {
  Tree(Surface<Dim> s, const std::vector<Index>& crossing) : surface(std::move(s)), facets(surface), normals(surface) {
    const Box<Dim> box = bounding_box(surface.vertices);
    rounding = 1e-12 * std::max(box.max.cwiseAbs().maxCoeff(), box.min.cwiseAbs().maxCoeff());
    if constexpr (Dim == 3) {
      if (crossing.empty()) return;
      is_doubtful.resize(surface.vertices.size());
      for (const Index f : crossing)
        for (const Index v : surface.facets[f]) is_doubtful[v] = true;
      winding.emplace(surface);
    }
  }

  // Of facets whose sides the pseudonormal may confuse: does the surface wind about x?
  bool encloses(const Vec<Dim>& x, Index facet, FeatureMask feature) const {
    if constexpr (Dim == 3) {
      if (!winding) return true;
      for (int k = 0; k < Dim; ++k)
        if (((feature >> k) & 1u) != 0 && !is_doubtful[surface.facets[facet][k]]) return true;
      return (*winding)(x) > 0;
    }
    return true;
  }

  Surface<Dim> surface;
  FacetTree<Dim> facets;
  Pseudonormals<Dim> normals;
  double rounding;                // below this distance, rounding spoils the direction from the surface to a point
  std::vector<bool> is_doubtful;  // vertices of facets that cross others
  std::optional<CrossingNumber> winding;  // where there are any
};

template <int Dim>
SignedDistance<Dim>::SignedDistance(Surface<Dim> surface, const std::vector<Index>& crossing) {
  SHELLMATCH_CHECK(!surface.facets.empty(), "the distance to a surface without facets is not defined");
  tree_ = std::make_unique<Tree>(std::move(surface), crossing);
}

template <int Dim>
SignedDistance<Dim>::~SignedDistance() = default;
template <int Dim>
SignedDistance<Dim>::SignedDistance(SignedDistance&&) noexcept = default;
template <int Dim>
SignedDistance<Dim>& SignedDistance<Dim>::operator=(SignedDistance&&) noexcept = default;

template <int Dim>
const Surface<Dim>& SignedDistance<Dim>::surface() const {
  return tree_->surface;
}

template <int Dim>
ClosestPoint<Dim> SignedDistance<Dim>::closest(const Vec<Dim>& x) const {
  return closest_on(tree_->facets.nearest(x), x);
}

template <int Dim>
template <class Take>
void SignedDistance<Dim>::for_each_closest(std::span<const Vec<Dim>> x, Take&& take) const {
  std::array<Index, 64> facets;
  for (std::size_t begin = 0; begin < x.size(); begin += facets.size()) {
    const std::size_t n = std::min(facets.size(), x.size() - begin);
    tree_->facets.nearest(x.subspan(begin, n), std::span(facets).first(n));
    for (std::size_t i = 0; i < n; ++i) take(begin + i, closest_on(facets[i], x[begin + i]));
  }
}

template <int Dim>
void SignedDistance<Dim>::operator()(std::span<const Vec<Dim>> x, std::span<double> distances) const {
  for_each_closest(x, [&](std::size_t i, const ClosestPoint<Dim>& found) { distances[i] = found.signed_distance; });
}

template <int Dim>
void SignedDistance<Dim>::closest(std::span<const Vec<Dim>> x, std::span<ClosestPoint<Dim>> found) const {
  for_each_closest(x, [&](std::size_t i, const ClosestPoint<Dim>& one) { found[i] = one; });
}

template <int Dim>
ClosestPoint<Dim> SignedDistance<Dim>::closest_on(Index facet, const Vec<Dim>& x) const {
  SHELLMATCH_CHECK(facet != no_index, "a point whose distance is asked for is not finite");
  const auto [point, feature] = closest_point_on_facet(tree_->surface, facet, x);
  const Vec<Dim>& pseudonormal = tree_->normals(tree_->surface, facet, feature);
  const Vec<Dim> difference = x - point;
  double distance = std::copysign(difference.norm(), difference.dot(pseudonormal));
  const bool is_turned = distance < -tree_->rounding && !tree_->encloses(x, facet, feature);
  if (is_turned) distance = -distance;
  // Over the interior of a facet the gradient is its normal. Elsewhere the pseudonormal replaces a direction
  // that consists of rounding errors.
  const bool take_pseudonormal = !is_turned && (feature == inside_facet<Dim> || std::abs(distance) <= tree_->rounding);
  return {distance, point, take_pseudonormal ? pseudonormal : Vec<Dim>(difference / distance), facet};
}

template <int Dim>
const Vec<Dim>& SignedDistance<Dim>::pseudonormal(const ClosestPoint<Dim>& found) const {
  const Surface<Dim>& surface = tree_->surface;
  const FacetPoint<Dim> on_facet = closest_point_on_facet(surface, found.facet, found.point);
  const std::array<double, Dim> weights = barycentric_coordinates(surface, found.facet, on_facet);
  FeatureMask feature = on_facet.feature;
  for (int k = 0; k < Dim; ++k)
    if (weights[k] < 1e-6) feature &= ~(1u << k);
  return tree_->normals(surface, found.facet, feature);
}

template class SignedDistance<2>;
template class SignedDistance<3>;

}  // namespace shellmatch
