#include "geometry/generate/box.h"

#include "base/error.h"
#include "geometry/implicit/mesh_implicit.h"

namespace shellmatch {

Body<3> box_body(const BoxOptions& options, double edge_length) {
  const Vec<3> half_sides = 0.5 * Vec<3>(options.side_x, options.side_y, options.side_z);
  if (options.rounding > half_sides.minCoeff())
    throw_input_error("box: rounding {:g} exceeds half the shortest side, {:g}; choose a smaller one", options.rounding,
                      half_sides.minCoeff());
  Body<3> body;
  body.rest =
      mesh_implicit([&](const Vec<3>& x) { return rounded_box(x - domain_centre<3>(), half_sides, options.rounding); },
                    edge_length, "box");
  for (Vec<3>& x : body.rest.vertices) x -= domain_centre<3>();
  const Mat<3> turn = Eigen::AngleAxisd(radians(options.turn), Vec<3>::Unit(options.turn_axis - 1)).toRotationMatrix();
  const Mat<3> linear = turn * Vec<3>(options.compression, 1, 1).asDiagonal();
  body.pose = [linear](const Vec<3>& x) -> Vec<3> { return domain_centre<3>() + linear * x; };
  return body;
}

}  // namespace shellmatch
