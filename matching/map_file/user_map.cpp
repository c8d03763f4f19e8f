#include "matching/map_file/user_map.h"

#include <Eigen/LU>

#include <cmath>

namespace shellmatch {

template <int Dim>
UserMap<Dim>::UserMap(const Deformation<Dim>& map, Toward toward, bool keep_pose)
    : map_(&map), toward_(toward), keep_pose_(keep_pose), points_(map, toward) {
  image_low_ = Vec<Dim>::Constant(infinity);
  image_high_ = -image_low_;
  for (const Vec<Dim>& y : map.phi) {
    image_low_ = image_low_.cwiseMin(y);
    image_high_ = image_high_.cwiseMax(y);
  }
}

template <int Dim>
std::optional<Vec<Dim>> UserMap<Dim>::operator()(const Vec<Dim>& x) const {
  const auto y = points_(entering(x));
  return y ? std::optional<Vec<Dim>>(leaving(*y)) : std::nullopt;
}

template <int Dim>
std::optional<Vec<Dim>> UserMap<Dim>::within_domain(const Vec<Dim>& x) const {
  const auto is_inside = [&](const Vec<Dim>& p) {
    const Vec<Dim> unit = map_->to_unit_domain(p);
    return (unit.array() >= 0).all() && (unit.array() <= 1).all();
  };
  const Vec<Dim> p = entering(x);
  if (points_.is_inverse()) {
    // Beyond the box there is nothing to search.
    const Vec<Dim> unit = map_->placement(p);
    if ((unit.array() < image_low_.array()).any() || (unit.array() > image_high_.array()).any()) return std::nullopt;
  } else if (!is_inside(p)) {
    return std::nullopt;
  }
  const auto y = points_(p);
  if (!y || (points_.is_inverse() && !is_inside(*y))) return std::nullopt;
  return leaving(*y);
}

template <int Dim>
std::optional<double> UserMap<Dim>::determinant(const Vec<Dim>& x) const {
  const Vec<Dim> p = entering(x);
  const auto y = points_(p);
  if (!y) return std::nullopt;
  // The placement cancels, and a pose that mirrors is no fold.
  double scale = std::pow(map_->pose.scale, Dim);
  const double of_phi =
      map_->jacobian_in_unit_domain(map_->to_unit_domain(points_.is_inverse() ? *y : p)).determinant() * scale;
  const double determinant = points_.is_inverse() ? 1 / of_phi : of_phi;
  if (!keep_pose_) return determinant;
  // The pose is that of the template where the map was solved backward.
  if (map_->is_backward) scale = 1 / scale;
  return toward_ == Toward::template_shape ? determinant / scale : determinant * scale;
}

template class UserMap<2>;
template class UserMap<3>;

}  // namespace shellmatch
