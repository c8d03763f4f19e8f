#include "geometry/implicit/implicit_function.h"

#include <algorithm>
#include <cmath>

namespace shellmatch {

double smooth_union(double a, double b, double width) {
  const double gap = std::abs(a - b);
  if (gap >= width) return std::min(a, b);
  const double overlap = std::max(1 - gap / width, 0.0);
  return std::min(a, b) - width / 6 * overlap * overlap * overlap;
}

// In the half plane (along, across) the mantle is a segment with the unit normal (sine, cosine).
RoundedCone::RoundedCone(const Vec<3>& a, const Vec<3>& b, double ra, double rb)
    : a_(a), axis_(b - a), ra_(ra), rb_(rb) {
  length_ = axis_.norm();
  sine_ = (ra - rb) / length_;
  cosine_ = std::sqrt(1 - sine_ * sine_);
}

double RoundedCone::operator()(const Vec<3>& x) const {
  const double along = (x - a_).dot(axis_) / length_;
  const double across = std::sqrt(std::max((x - a_).squaredNorm() - along * along, 0.0));
  const double on_mantle = along * cosine_ - across * sine_;
  if (on_mantle <= 0) return std::sqrt(along * along + across * across) - ra_;
  if (on_mantle >= length_ * cosine_) return std::sqrt((along - length_) * (along - length_) + across * across) - rb_;
  return along * sine_ + across * cosine_ - ra_;
}

double rounded_box(const Vec<3>& x, const Vec<3>& half_sides, double radius) {
  const Vec<3> q = (x.cwiseAbs() - half_sides).array() + radius;
  return q.cwiseMax(0).norm() + std::min(q.maxCoeff(), 0.0) - radius;
}

double ellipsoid_function(const Vec<3>& x, const Vec<3>& semi_axes) {
  const double level = x.cwiseQuotient(semi_axes).norm();
  const double slope = x.cwiseQuotient(semi_axes.cwiseAbs2()).norm();
  // The quotient has no limit at the centre; any value below -(smallest semi-axis)/2 is valid there.
  if (level < 1e-3) return -0.999 * semi_axes.minCoeff();
  return level * (level - 1) / slope;
}

double rounded_plate(const Vec<3>& x, std::span<const Vec<2>> polygon, double half_thickness, double radius) {
  const Vec<2> p = x.head<2>();
  double squared = (p - polygon[0]).squaredNorm();
  bool inside = true;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec<2>&a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const Vec<2> e = b - a, w = p - a;
    squared = std::min(squared, (w - e * std::clamp(w.dot(e) / e.squaredNorm(), 0.0, 1.0)).squaredNorm());
    inside = inside && e.x() * w.y() - e.y() * w.x() >= 0;
  }
  const double in_plane = inside ? -std::sqrt(squared) : std::sqrt(squared);
  const double off_plane = std::abs(x.z()) - half_thickness;
  return std::hypot(std::max(in_plane, 0.0), std::max(off_plane, 0.0)) + std::min(std::max(in_plane, off_plane), 0.0) -
         radius;
}

Vec<3> implicit_gradient(const ImplicitFunction& f, const Vec<3>& x) {
  constexpr double step = 1e-5;
  Vec<3> gradient;
  for (int k = 0; k < 3; ++k) {
    Vec<3> right = x, left = x;
    right[k] += step;
    left[k] -= step;
    gradient[k] = (f(right) - f(left)) / (2 * step);
  }
  return gradient;
}

Vec<3> project_to_zero(const ImplicitFunction& f, Vec<3> x) {
  for (int step = 0; step < 10; ++step) {
    const double value = f(x);
    if (std::abs(value) < 1e-12) break;
    const Vec<3> gradient = implicit_gradient(f, x);
    x -= value / std::max(gradient.squaredNorm(), 0.01) * gradient;
  }
  return x;
}

}  // namespace shellmatch
