#include "energies/fields/geometry_field.h"

#include "grid/fields/interpolation.h"
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
  static constexpr int n = GeometryField<Dim>::n_values;
  using Values = Eigen::Matrix<double, n, 1>;
  using Derivative = Eigen::Matrix<double, n, Dim>;

  explicit Lookup(bool smooth) : field_(field(grid_, fields_, smooth)) {}

  Values value(const Vec<Dim>& y) const { return flat(field_.value(y)); }
  Derivative derivative(const Vec<Dim>& y) const {
    std::array<typename GeometryField<Dim>::Values, Dim> d;
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
  const GeometryField<Dim>& geometry() const { return field_; }

 private:
  static Values flat(const typename GeometryField<Dim>::Values& row) { return Eigen::Map<const Values>(row.data()); }

  const Octree<Dim> grid_ = hanging_grid<Dim>(0.4);
  const CoefficientFields<Dim> fields_ = exact_fields<Dim>(grid_, ellipsoid<Dim>(Vec<Dim>::LinSpaced(0.4, 0.3)));
  const GeometryField<Dim> field_;
};

// As the field keeps them.
std::vector<double> in_single_precision(std::vector<double> values) {
  for (double& x : values) x = static_cast<double>(static_cast<float>(x));
  return values;
}

template <int Dim>
std::vector<Vec<Dim>> in_single_precision(std::vector<Vec<Dim>> values) {
  for (Vec<Dim>& x : values) x = x.template cast<float>().eval().template cast<double>();
  return values;
}

template <int Dim>
void check_inside_and_outside(bool smooth) {
  const Lookup<Dim> lookup(smooth);
  const auto distances = in_single_precision(lookup.fields().distance);
  const auto normals = in_single_precision<Dim>(lookup.fields().normal);
  std::mt19937 random(1);
  for (int i = 0; i < 2000; ++i) {
    const Vec<Dim> y = random_point<Dim>(random, -0.5, 1.5), inside = y.cwiseMax(0.0).cwiseMin(1.0);
    const auto v = lookup.value(y);
    const auto d = lookup.derivative(y);
    const double linear = evaluate(lookup.grid(), distances, inside);
    const Vec<Dim> normal = evaluate(lookup.grid(), normals, inside);
    if (smooth) {
      EXPECT_LT(std::abs(v[0] - linear), 0.05) << "near the nodes' values";
    } else {
      EXPECT_NEAR(v[0], linear, 1e-14);
      EXPECT_LT((v.template segment<Dim>(1) - normal).norm(), 1e-13);
    }
    const auto [jet_value, jet_derivative] = lookup.with_jets(y);
    EXPECT_LT((v - jet_value).norm(), 1e-13 * (1 + v.norm()));
    EXPECT_LT((d - jet_derivative).norm(), 1e-12 * (1 + d.norm()));
    for (int k = 0; k < Dim; ++k)
      EXPECT_EQ(d.col(k).norm() == 0, y[k] < 0 || y[k] > 1) << "no derivative in a projected direction, and only there";
  }
}

TEST(GeometryField, InterpolatesInsideAndProjectsOutside) {
  for (const bool smooth : {false, true}) {
    check_inside_and_outside<2>(smooth);
    check_inside_and_outside<3>(smooth);
  }
}

template <int Dim>
void check_continuity(bool smooth) {
  const Lookup<Dim> lookup(smooth);
  std::mt19937 random(2);
  double greatest_jump = 0;
  // Across faces of all sizes, and across the domain's boundary.
  for (int i = 0; i < 2000; ++i) {
    Vec<Dim> y = random_point<Dim>(random);
    const int axis = i % Dim;
    y[axis] = std::round(y[axis] * 32) / 32;
    Vec<Dim> step = Vec<Dim>::Zero();
    step[axis] = 1e-10;
    EXPECT_LT((lookup.value(y + step) - lookup.value(y - step)).norm(), 1e-6);
    EXPECT_LT((lookup.value(y) - lookup.value(y - step)).norm(), 1e-6);
    if (y[axis] > 0 && y[axis] < 1)
      greatest_jump = std::max(greatest_jump, (lookup.derivative(y + step) - lookup.derivative(y - step)).norm());
  }
  if (smooth) EXPECT_LT(greatest_jump, 1e-5);
  else EXPECT_GT(greatest_jump, 1e-2);
}

TEST(GeometryField, IsContinuousAndIfSmoothSoIsItsDerivative) {
  for (const bool smooth : {false, true}) {
    check_continuity<2>(smooth);
    check_continuity<3>(smooth);
  }
}

// Least values of the distance, a normal's entry and a root's where all are 1 or 20 at the nodes, at random.
template <int Dim>
std::array<double, 3> least_of_jagged(bool keep_definite) {
  const Octree<Dim> grid = hanging_grid<Dim>(0.4);
  std::mt19937 random(4);
  CoefficientFields<Dim> nodal;
  for (Index i = 0; i < grid.n_nodes(); ++i) {
    const double value = random() % 2 ? 1 : 20;
    nodal.distance.push_back(value);
    nodal.normal.push_back(Vec<Dim>::Constant(value));
    nodal.root.push_back(pack_symmetric<Dim>(value * Mat<Dim>::Identity()));
  }
  const auto jagged = GeometryField<Dim>::smooth(grid, nodal.distance, nodal.normal, nodal.root, keep_definite);
  std::array<double, 3> least{20, 20, 20};
  for (int i = 0; i < 3000; ++i) {
    const auto v = jagged.value(random_point<Dim>(random));
    for (int k = 0; k < 3; ++k) least[k] = std::min(least[k], v[std::array{0, 1, 1 + Dim}[k]]);
  }
  return least;
}

template <int Dim>
void check_definite() {
  const auto kept = least_of_jagged<Dim>(true), sharp = least_of_jagged<Dim>(false);
  EXPECT_LT(kept[0], 0) << "distances are sharp,";
  EXPECT_LT(kept[1], 0) << "and so are normals";
  EXPECT_GE(kept[2], 1 - 1e-12);
  EXPECT_LT(sharp[2], 0);
}

TEST(GeometryField, SmoothRootsStayPositiveDefinite) {
  check_definite<2>();
  check_definite<3>();
}

template <int Dim>
void check_packs(bool smooth) {
  using Field = GeometryField<Dim>;
  const Lookup<Dim> lookup(smooth);
  std::mt19937 random(3);
  for (int i = 0; i < 100; ++i) {
    autodiff::Pack weight{};
    std::array<autodiff::Pack, Dim> y;
    std::array<Vec<Dim>, autodiff::pack_size> place;
    for (int lane = 0; lane < autodiff::pack_size; ++lane) {
      weight[lane] = (lane + i) % 3 == 0 ? 0.0 : 0.5;
      place[lane] = random_point<Dim>(random, -0.1, 1.1);
      for (int k = 0; k < Dim; ++k) y[k][lane] = weight[lane] > 0 ? place[lane][k] : std::nan("");
    }
    typename Field::Packs values, again;
    std::array<typename Field::Packs, Dim> derivative;
    lookup.geometry().look_up(weight, lookup.geometry().find(y), values.data(), derivative);
    lookup.geometry().look_up(weight, lookup.geometry().find(y), again.data());
    for (int lane = 0; lane < autodiff::pack_size; ++lane) {
      std::array<typename Field::Values, Dim> d{};
      typename Field::Values v{};
      v[1] = 1;
      if (weight[lane] > 0) v = lookup.geometry().value(place[lane], d);
      for (int c = 0; c < Field::n_values; ++c) {
        EXPECT_EQ(values[c][lane], v[c]);
        EXPECT_EQ(again[c][lane], v[c]);
        for (int k = 0; k < Dim; ++k) EXPECT_EQ(derivative[k][c][lane], d[k][c]);
      }
    }
  }
}

TEST(GeometryField, EightPointsAtOnceAreOneAfterTheOther) {
  for (const bool smooth : {false, true}) {
    check_packs<2>(smooth);
    check_packs<3>(smooth);
  }
}

/// Cubes of each leaf, its eighth in the upper corner and its parent: only the last one spans several leaves of the
/// finest size.
template <int Dim>
void check_cubes() {
  const Lookup<Dim> lookup(true);
  const GeometryField<Dim>& field = lookup.geometry();
  const std::array at{0.1, 0.35, 0.5, 0.93};
  const std::size_t n_points = Dim == 2 ? 16 : 64;
  std::vector<typename GeometryField<Dim>::Packs> values(n_points / autodiff::pack_size);
  for (const Index leaf : lookup.grid().leaves()) {
    const auto& cell = lookup.grid().cell(leaf);
    Vec<Dim> corner;
    for (int k = 0; k < Dim; ++k) corner[k] = cell.corner[k] * cell.side();
    for (const double share : {1.0, 0.5}) {
      const double side = share * cell.side();
      const Vec<Dim> from = corner + Vec<Dim>::Constant((1 - share) * cell.side());
      ASSERT_TRUE(field.look_up_cube(from, side, at, values));
      for (std::size_t q = 0; q < n_points; ++q) {
        Vec<Dim> y = from;
        for (std::size_t k = 0, rest = q; k < Dim; ++k, rest /= at.size())
          y[static_cast<int>(k)] += side * at[rest % at.size()];
        const auto expected = field.value(y);
        for (std::size_t i = 0; i < expected.size(); ++i)
          ASSERT_NEAR(values[q / autodiff::pack_size][i][q % autodiff::pack_size], expected[i],
                      1e-12 * (1 + std::abs(expected[i])));
      }
    }
    if (cell.level < lookup.grid().finest_level()) continue;
    Vec<Dim> parent;
    for (int k = 0; k < Dim; ++k) parent[k] = (cell.corner[k] & ~1) * cell.side();
    EXPECT_FALSE(field.look_up_cube(parent, 2 * cell.side(), at, values));
  }
  EXPECT_FALSE(Lookup<Dim>(false).geometry().look_up_cube(Vec<Dim>::Zero(), 1.0 / 64, at, values)) << "multilinear";
}

TEST(GeometryField, PointsOfACubeAreOneAfterTheOther) {
  check_cubes<2>();
  check_cubes<3>();
  // The last point fills up.
  const Lookup<3> lookup(true);
  std::vector<GeometryField<3>::Packs> values(1);
  const double side = 0.25 * std::ldexp(1.0, -lookup.grid().finest_level());
  ASSERT_TRUE(lookup.geometry().look_up_cube(Vec<3>::Constant(0.5), side, std::array{0.5}, values));
  for (int lane = 1; lane < autodiff::pack_size; ++lane)
    for (const auto& value : values[0]) EXPECT_EQ(value[lane], value[0]);
}

}  // namespace
}  // namespace shellmatch
