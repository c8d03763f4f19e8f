#pragma once
/// \file
/// The map of a run as its user sees it: in either direction, with or without the pose, and where it is defined.

#include "geometry/volume/volume.h"
#include "matching/level/deformation.h"

#include <optional>

namespace shellmatch {

/// A point in RAS, as volumes are, in the frame of the map; and from there to RAS, as the conversion is its own
/// inverse.
inline Vec<3> exchange_with_ras(const MapFrame<3>& frame, const Vec<3>& x) {
  return in_space(x, Space::ras, or_default(frame.space));
}

template <int Dim>
class UserMap {
 public:
  /// \param map must outlive this object \param keep_pose points of the template lie where the reference does
  UserMap(const Deformation<Dim>& map, Toward toward, bool keep_pose);

  /// None where the inverse of phi is asked for and has no value.
  std::optional<Vec<Dim>> operator()(const Vec<Dim>& x) const;

  /// The same; none beyond the domain of phi, too.
  std::optional<Vec<Dim>> within_domain(const Vec<Dim>& x) const;

  /// By what the map multiplies volumes around x; negative where it is folded. None as of operator().
  std::optional<double> determinant(const Vec<Dim>& x) const;

 private:
  Vec<Dim> entering(const Vec<Dim>& x) const {
    return keep_pose_ && toward_ == Toward::reference ? map_->from_reference_pose(x) : x;
  }
  Vec<Dim> leaving(const Vec<Dim>& y) const {
    return keep_pose_ && toward_ == Toward::template_shape ? map_->to_reference_pose(y) : y;
  }

  const Deformation<Dim>* map_;
  Toward toward_;
  bool keep_pose_;
  PointMap<Dim> points_;
  Vec<Dim> image_low_, image_high_;  ///< the box of phi's values; unit domain
};

}  // namespace shellmatch
