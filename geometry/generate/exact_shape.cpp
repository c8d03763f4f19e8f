#include "geometry/generate/exact_shape.h"

#include "geometry/generate/families.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace shellmatch {

namespace {

// The level set F = const with this gradient and Hessian of F has the shape operator P D^2F P/|grad F|.
template <int Dim>
Mat<Dim> level_set_operator(const Vec<Dim>& gradient, const Mat<Dim>& hessian) {
  const Vec<Dim> n = gradient.normalized();
  const Mat<Dim> p = Mat<Dim>::Identity() - n * n.transpose();
  return p * hessian * p / gradient.norm();
}

// The point x of the ellipsoid nearest to y satisfies y - x = t x/a^2 with t > -min a^2, hence sum (a y/(a^2
// + t))^2 = 1, whose left side decreases with t. If it is below 1 even for the smallest t, y lies on the
// medial disc, and the coordinate of x along the shortest axis follows from the equation of the ellipsoid.
template <int Dim>
double ellipsoid_distance(const Vec<Dim>& a, const Vec<Dim>& y) {
  int shortest = 0;
  const double least = a.minCoeff(&shortest) * a.minCoeff();
  const auto point = [&](double t) { return Vec<Dim>(a.array().square() * y.array() / (a.array().square() + t)); };
  const auto excess = [&](const Vec<Dim>& x) { return x.cwiseQuotient(a).squaredNorm() - 1; };
  double low = -least, high = y.norm() * a.maxCoeff();
  for (int i = 0; i < 100 && high - low > 1e-17 + 1e-16 * std::abs(high); ++i) {
    const double middle = 0.5 * (low + high);
    (excess(point(middle)) > 0 ? low : high) = middle;
  }
  Vec<Dim> x = point(high);
  if (const double missing = -excess(x); missing > 1e-9) {
    const double share = x[shortest] / a[shortest];
    x[shortest] = std::copysign(a[shortest] * std::sqrt(missing + share * share), y[shortest]);
  }
  return std::copysign((y - x).norm(), excess(y));
}

}  // namespace

template <int Dim>
ExactShape<Dim> exact_ellipsoid(const Vec<Dim>& semi_axes, const Vec<Dim>& centre, const Mat<Dim>& turn) {
  const Vec<Dim> inverse_squares = semi_axes.array().square().inverse();
  return {[=](const Vec<Dim>& x) { return ellipsoid_distance<Dim>(semi_axes, turn.transpose() * (x - centre)); },
          [=](const Vec<Dim>& x) {
            const Vec<Dim> gradient = inverse_squares.asDiagonal() * (turn.transpose() * (x - centre));
            return Mat<Dim>(turn * level_set_operator<Dim>(gradient, inverse_squares.asDiagonal()) * turn.transpose());
          }};
}

ExactShape<3> exact_torus(double major_radius, double minor_radius, const Vec<3>& centre) {
  return {[=](const Vec<3>& x) {
            const Vec<3> y = x - centre;
            return std::hypot(std::hypot(y[0], y[1]) - major_radius, y[2]) - minor_radius;
          },
          [=](const Vec<3>& x) {
            const Vec<3> y = x - centre;
            const double rho = std::hypot(y[0], y[1]), s = rho - major_radius;
            const Vec<3> radial(y[0] / rho, y[1] / rho, 0), around(-radial[1], radial[0], 0);
            // F = (s^2 + z^2)/2, whose gradient has the norm of the minor radius.
            const Mat<3> hessian = radial * radial.transpose() + Vec<3>::UnitZ() * Vec<3>::UnitZ().transpose() +
                                   (s / rho) * around * around.transpose();
            return level_set_operator<3>(s * radial + y[2] * Vec<3>::UnitZ(), hessian);
          }};
}

std::optional<AnyExactShape> exact_shape(std::string_view name, std::string_view variant) {
  const GeneratorParameters p = complete_parameters(find_family(name).info, variant, {});
  if (name == "circle") return exact_ellipsoid<2>(Vec<2>::Constant(p.at("radius")), domain_centre<2>());
  if (name == "ellipse")
    return exact_ellipsoid<2>({p.at("semi_x"), p.at("semi_y")}, domain_centre<2>(),
                              Eigen::Rotation2Dd(radians(p.at("turn"))).toRotationMatrix());
  if (name == "sphere") return exact_ellipsoid<3>(Vec<3>::Constant(p.at("radius")), domain_centre<3>());
  if (name == "ellipsoid")
    return exact_ellipsoid<3>({p.at("semi_x"), p.at("semi_y"), p.at("semi_z")}, domain_centre<3>());
  if (name == "torus") return exact_torus(p.at("major_radius"), p.at("minor_radius"), domain_centre<3>());
  return std::nullopt;
}

SHELLMATCH_2D_3D(exact_ellipsoid);

}  // namespace shellmatch
