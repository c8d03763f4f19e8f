#pragma once
/// \file
/// Built-in shapes whose distance and curvatures are known in closed form: references for what is computed
/// from meshes and grids.

#include "base/types.h"

#include <functional>
#include <optional>
#include <string_view>
#include <variant>

namespace shellmatch {

/// Distance and shape operator in the coordinates of the generated shape.
template <int Dim>
struct ExactShape {
  std::function<double(const Vec<Dim>&)> distance;  ///< signed, negative inside; defined everywhere
  /// D^2 of the distance at a point x of the surface: eigenvalues are the principal curvatures, positive
  /// where convex, with their directions, and 0 along the normal.
  std::function<Mat<Dim>(const Vec<Dim>& x)> shape_operator;
};

using AnyExactShape = std::variant<ExactShape<2>, ExactShape<3>>;

/// For the circle, ellipse, sphere, ellipsoid and torus of generate_shape(name, variant); nothing for other
/// shapes.
/// \throws InputError for unknown names and variants
std::optional<AnyExactShape> exact_shape(std::string_view name, std::string_view variant = "");

/// The ellipse or ellipsoid with these semi-axes, rotated by `turn` (its columns are the images of the
/// coordinate axes) and centred at `centre`.
template <int Dim>
ExactShape<Dim> exact_ellipsoid(const Vec<Dim>& semi_axes, const Vec<Dim>& centre,
                                const Mat<Dim>& turn = Mat<Dim>::Identity());

/// The torus about the axis through `centre` along z.
ExactShape<3> exact_torus(double major_radius, double minor_radius, const Vec<3>& centre);

}  // namespace shellmatch
