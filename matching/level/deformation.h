#pragma once
/// \file
/// The result of a matching: a volumetric map phi on its grid, the similarity between the user's coordinates and the
/// unit domain, and the pose that was taken out before.

#include "geometry/distance/surface_bend.h"
#include "geometry/surface/placement.h"
#include "geometry/surface/space.h"
#include "geometry/surface/surface.h"
#include "grid/inverse/inverse_map.h"
#include "grid/octree/octree.h"

#include <memory>
#include <optional>
#include <vector>

namespace shellmatch {

/// How a map of the unit domain lies in the user's coordinates.
template <int Dim>
struct MapFrame {
  Similarity<Dim> placement = {};
  Similarity<Dim> pose = {};  ///< moves points before anything else; user's coordinates
  /// The matching was solved backward: phi carries the template onto the reference, and its inverse is the map of the
  /// reference (PointMap).
  bool is_backward = false;
  Space space = Space::unsaid;  ///< the frame of the user's coordinates, where the shapes named it
  /// Moves points of the reference before the pose; user's coordinates. With it the map is one of the reference's
  /// surface alone, and never backward. Null: there is none.
  std::shared_ptr<const SurfaceBend<Dim>> bend = {};

  Vec<Dim> to_unit_domain(const Vec<Dim>& x) const { return placement(pose(bend ? (*bend)(x) : x)); }

  /// A point of the template moved by the inverse of the pose of the reference onto the template: from where the
  /// template lies to where the reference does.
  Vec<Dim> to_reference_pose(const Vec<Dim>& y) const { return is_backward ? pose(y) : pose.inverse(y); }
  Vec<Dim> from_reference_pose(const Vec<Dim>& y) const { return is_backward ? pose.inverse(y) : pose(y); }
};

template <int Dim>
struct Deformation : MapFrame<Dim> {
  Octree<Dim> grid;
  std::vector<Vec<Dim>> phi;  ///< deformed positions of all nodes, hanging nodes included; unit domain

  /// The image of a point under phi, both in the user's coordinates.
  Vec<Dim> apply(const Vec<Dim>& x) const {
    return this->placement.inverse(apply_in_unit_domain(this->to_unit_domain(x)));
  }

  /// The same in coordinates of the unit domain: phi(x). A point outside it gets the displacement of the nearest point
  /// of the domain.
  Vec<Dim> apply_in_unit_domain(const Vec<Dim>& x) const;

  /// The derivative of apply_in_unit_domain(): Dphi, on a face between cells its limit from inside one of them.
  Mat<Dim> jacobian_in_unit_domain(const Vec<Dim>& x) const;

  /// The derivative of apply() at x. A similarity scales in all directions alike, so that of the placement cancels.
  Mat<Dim> jacobian(const Vec<Dim>& x) const {
    return jacobian_in_unit_domain(this->to_unit_domain(x)) * this->pose.rotation * this->pose.scale;
  }
};

/// The inverse of Deformation::apply().
template <int Dim>
class InverseDeformation {
 public:
  /// \param map must outlive this object
  explicit InverseDeformation(const Deformation<Dim>& map) : map_(&map), inverse_(map.grid, map.phi) {}

  /// The x with map.apply(x) = y, both in the user's coordinates; none as InverseMap says.
  std::optional<Vec<Dim>> operator()(const Vec<Dim>& y) const {
    const std::optional<Vec<Dim>> x = inverse_(map_->placement(y));
    if (!x) return std::nullopt;
    const Vec<Dim> undeformed = map_->pose.inverse(map_->placement.inverse(*x));
    return map_->bend ? map_->bend->inverse(undeformed) : undeformed;
  }

 private:
  const Deformation<Dim>* map_;
  InverseMap<Dim> inverse_;
};

/// The surface with its vertices moved by phi; unit domain.
template <int Dim>
Surface<Dim> deformed_surface(const Surface<Dim>& surface, const Octree<Dim>& grid, const std::vector<Vec<Dim>>& phi);

/// A map at the nodes of another grid; hanging nodes are set. \pre both lie in one unit domain
template <int Dim>
std::vector<Vec<Dim>> sampled_map(const Deformation<Dim>& map, const Octree<Dim>& grid);

enum class Toward { template_shape, reference };

/// Carries points from one shape to the other, in whichever direction the matching was solved.
template <int Dim>
class PointMap {
 public:
  /// \param map must outlive this object
  PointMap(const Deformation<Dim>& map, Toward toward) : map_(&map) {
    if (map.is_backward == (toward == Toward::template_shape)) inverse_.emplace(map);
  }

  bool is_inverse() const { return inverse_.has_value(); }

  /// Both in the user's coordinates. None where the inverse of phi is asked for and has no value.
  std::optional<Vec<Dim>> operator()(const Vec<Dim>& x) const { return inverse_ ? (*inverse_)(x) : map_->apply(x); }

  /// The derivative there; none where there is no value or, for an inverse, where phi is singular.
  std::optional<Mat<Dim>> jacobian(const Vec<Dim>& x) const;

 private:
  const Deformation<Dim>* map_;
  std::optional<InverseDeformation<Dim>> inverse_;
};

}  // namespace shellmatch
