#include "energies/target_field.h"

#include "grid/interpolation.h"
#include "tests/energies/exact_shapes.h"
#include "tests/energies/matching_problem.h"
#include "tests/grid/test_grids.h"

#include <gtest/gtest.h>

namespace shellmatch {
namespace {

using namespace test;

template <int Dim>
class Lookup {
 public:
  static constexpr int n = TargetField<Dim>::n_values;
  using Values = Eigen::Matrix<double, n, 1>;
  using Derivative = Eigen::Matrix<double, n, Dim>;

  Values value(const Vec<Dim>& y) const { return flat(field_.value(y)); }
  Derivative derivative(const Vec<Dim>& y) const {
    std::array<typename TargetField<Dim>::Row, Dim> d;
    EXPECT_EQ(flat(field_.value(y, d)), value(y));
    Derivative m;
    for (int k = 0; k < Dim; ++k) m.col(k) = flat(d[k]);
    return m;
  }
  // Value and derivative by Ceres' dual numbers.
  std::pair<Values, Derivative> with_jets(const Vec<Dim>& y) const {
    using Jet = ceres::Jet<double, Dim>;
    SmallVec<Jet, Dim> j;
    for (int k = 0; k < Dim; ++k) j[k] = Jet(y[k], k);
    const auto p = field_.template at<Jet>(j);
    Values v;
    Derivative m;
    const auto put = [&](int i, const Jet& x) {
      v[i] = x.a;
      m.row(i) = x.v.transpose();
    };
    put(0, p.d2);
    for (int i = 0; i < Dim; ++i) put(1 + i, p.n2[i]);
    for (int i = 0; i < n_symmetric<Dim>; ++i) put(1 + Dim + i, p.root.v[i]);
    return {v, m};
  }
  const Octree<Dim>& grid() const { return grid_; }
  const CoefficientFields<Dim>& fields() const { return fields_; }

 private:
  static Values flat(const typename TargetField<Dim>::Row& row) {
    Values v;
    for (int i = 0; i < n; ++i) v[i] = row[i / 4][i % 4];
    return v;
  }
  const Octree<Dim> grid_ = hanging_grid<Dim>(0.4);
  const CoefficientFields<Dim> fields_ = exact_fields<Dim>(grid_, ellipsoid<Dim>(Vec<Dim>::LinSpaced(0.4, 0.3)));
  const TargetField<Dim> field_{grid_, fields_.distance, fields_.normal, fields_.root};
};

template <int Dim>
void check_inside_and_outside() {
  const Lookup<Dim> lookup;
  std::mt19937 random(1);
  for (int i = 0; i < 2000; ++i) {
    const Vec<Dim> y = random_point<Dim>(random, -0.5, 1.5), inside = y.cwiseMax(0.0).cwiseMin(1.0);
    const auto v = lookup.value(y);
    const auto d = lookup.derivative(y);
    EXPECT_NEAR(v[0], evaluate(lookup.grid(), lookup.fields().distance, inside), 1e-14);
    const Vec<Dim> normal = evaluate(lookup.grid(), lookup.fields().normal, inside);
    EXPECT_LT((v.template segment<Dim>(1) - normal).norm(), 1e-13);
    const auto [jet_value, jet_derivative] = lookup.with_jets(y);
    EXPECT_LT((v - jet_value).norm(), 1e-13 * (1 + v.norm()));
    EXPECT_LT((d - jet_derivative).norm(), 1e-12 * (1 + d.norm()));
    for (int k = 0; k < Dim; ++k)
      EXPECT_EQ(d.col(k).norm() == 0, y[k] < 0 || y[k] > 1) << "no derivative in a projected direction, and only there";
  }
}

TEST(TargetField, InterpolatesInsideAndProjectsOutside) {
  check_inside_and_outside<2>();
  check_inside_and_outside<3>();
}

template <int Dim>
void check_continuity() {
  const Lookup<Dim> lookup;
  std::mt19937 random(2);
  // Across faces of all sizes, and across the domain's boundary.
  for (int i = 0; i < 2000; ++i) {
    Vec<Dim> y = random_point<Dim>(random);
    const int axis = i % Dim;
    y[axis] = std::round(y[axis] * 32) / 32;
    Vec<Dim> step = Vec<Dim>::Zero();
    step[axis] = 1e-10;
    EXPECT_LT((lookup.value(y + step) - lookup.value(y - step)).norm(), 1e-6);
    EXPECT_LT((lookup.value(y) - lookup.value(y - step)).norm(), 1e-6);
  }
}

TEST(TargetField, IsContinuous) {
  check_continuity<2>();
  check_continuity<3>();
}

}  // namespace
}  // namespace shellmatch
