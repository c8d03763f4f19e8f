#pragma once
/// \file
/// The mesher that turns the zero level of a signed function into a closed surface of well-shaped triangles.

#include "geometry/implicit/implicit_function.h"
#include "geometry/surface/surface.h"

#include <string_view>

namespace shellmatch {

/// What is finer than the edges. `as_they_come`: sheets and threads of it are joined or cut as the lattice happens to
/// lie, with triangles that may be thin there; the surface is closed whatever the function.
enum class Details { needed, as_they_come };

/// The zero level of f within [0.04, 0.96]^3 as a closed, outward oriented, two-manifold triangle surface
/// with edges of about `edge_length` (in sides of the domain), its vertices on the zero level to rounding.
/// The result does not depend on the number of threads. \throws InputError naming `name` where edge_length is
/// too coarse for the body's details, unless `details` says otherwise, or where the body leaves [0.05, 0.95]^3.
Surface<3> mesh_implicit(const ImplicitFunction& f, double edge_length, std::string_view name,
                         Details details = Details::needed);

}  // namespace shellmatch
