#pragma once
/// \file
/// The result of a matching: a volumetric map phi on its grid, the similarity between the user's coordinates and the unit
/// domain, and the pose that was taken out before.

#include "geometry/surface/placement.h"
#include "grid/inverse/inverse_map.h"
#include "grid/octree/octree.h"

#include <optional>
#include <vector>

namespace shellmatch {

template <int Dim>
struct Deformation {
  Octree<Dim> grid;
  std::vector<Vec<Dim>> phi;     ///< deformed positions of all nodes, hanging nodes included; unit domain
  Similarity<Dim> placement;
  Similarity<Dim> pose = {};     ///< moves points of the reference before anything else; user's coordinates

  Vec<Dim> to_unit_domain(const Vec<Dim>& x) const { return placement(pose(x)); }

  /// The image of a point, both in the user's coordinates.
  Vec<Dim> apply(const Vec<Dim>& x) const { return placement.inverse(apply_in_unit_domain(to_unit_domain(x))); }

  /// The same in coordinates of the unit domain: phi(x). A point outside it gets the displacement of the nearest point of
  /// the domain.
  Vec<Dim> apply_in_unit_domain(const Vec<Dim>& x) const;
};

/// Carries points of the template back to the reference.
template <int Dim>
class InverseDeformation {
 public:
  /// \param map must outlive this object
  explicit InverseDeformation(const Deformation<Dim>& map) : map_(&map), inverse_(map.grid, map.phi) {}

  /// The x with map.apply(x) = y, both in the user's coordinates; none as InverseMap says.
  std::optional<Vec<Dim>> operator()(const Vec<Dim>& y) const {
    const std::optional<Vec<Dim>> x = inverse_(map_->placement(y));
    return x ? std::optional<Vec<Dim>>(map_->pose.inverse(map_->placement.inverse(*x))) : std::nullopt;
  }

 private:
  const Deformation<Dim>* map_;
  InverseMap<Dim> inverse_;
};

}  // namespace shellmatch
