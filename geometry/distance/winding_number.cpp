#include "geometry/distance/winding_number.h"

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

namespace shellmatch {

namespace {

double angle(const Surface<2>& surface, const std::array<Index, 2>& facet, const Vec<2>& x) {
  const Vec<2> a = surface.vertices[facet[0]] - x, b = surface.vertices[facet[1]] - x;
  return std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
}

/// van Oosterom and Strackee, 'The solid angle of a plane triangle', IEEE Trans. Biomed. Eng. 30(2), 1983,
/// (8).
double angle(const Surface<3>& surface, const std::array<Index, 3>& facet, const Vec<3>& x) {
  const Vec<3> a = surface.vertices[facet[0]] - x, b = surface.vertices[facet[1]] - x,
               c = surface.vertices[facet[2]] - x;
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  return 2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}

}  // namespace

template <int Dim>
double winding_number(const Surface<Dim>& surface, const Vec<Dim>& x) {
  double sum = 0;
  for (const auto& facet : surface.facets) sum += angle(surface, facet, x);
  return sum / (2 * (Dim - 1) * std::numbers::pi);
}

SHELLMATCH_2D_3D(winding_number);

}  // namespace shellmatch
