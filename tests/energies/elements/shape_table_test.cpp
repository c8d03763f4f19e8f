#include "energies/elements/shape_table.h"

#include <gtest/gtest.h>

namespace shellmatch {
namespace {

// Shape functions interpolate the coordinates of the unit cell.
TEST(ShapeTable, ReproducesLinearFunctions) {
  for (int order = 1; order <= 5; ++order)
    for (const auto& q : ShapeTable<3>(order).points) {
      Vec<3> position = Vec<3>::Zero();
      Mat<3> jacobian = Mat<3>::Zero();
      for (int c = 0; c < 8; ++c) {
        const Vec<3> corner(c & 1, (c >> 1) & 1, (c >> 2) & 1);
        position += q.n[c] * corner;
        jacobian += corner * Vec<3>(q.dn[c][0], q.dn[c][1], q.dn[c][2]).transpose();
      }
      EXPECT_LT((position - q.xi).norm(), 1e-15);
      EXPECT_LT((jacobian - Mat<3>::Identity()).norm(), 1e-15);
    }
}

}  // namespace
}  // namespace shellmatch
