#include "matching/level/shape_fields.h"

#include "matching/level/level_energy.h"
#include "matching/input/shape_source.h"
#include "energies/terms/term_names.h"

#include <gtest/gtest.h>

#include <random>

namespace shellmatch {
namespace {

template <int Dim>
SignedDistance<Dim> generated_distance(const std::string& name) {
  return SignedDistance<Dim>(std::get<Shape<Dim>>(open_shape("generate:" + name)).surface);
}

ExperimentOptions options(FieldInterpolation interpolation, RefineWhere refine = RefineWhere::reference) {
  ExperimentOptions o = profile_defaults(Profile::standard);
  o.coefficients.interpolation = interpolation;
  o.cascade.refine = refine;
  o.cascade.min_level = 3;
  return o;
}

/// Shapes and the grid of phi as a cascade leaves them at a level.
template <int Dim>
struct AtLevel {
  ShapeFields<Dim> fields;
  Octree<Dim> grid;
  AtLevel(const SignedDistance<Dim>& d1, const SignedDistance<Dim>& d2, const ExperimentOptions& o, int level)
      : fields(d1, d2, o), grid(o.cascade.min_level) {
    fields.compute_distances(grid);
    for (int l = o.cascade.min_level; l < level; ++l) {
      fields.refine(grid);
      fields.compute_distances(grid);
    }
  }
};

TEST(FieldGrid, IsFineAllAroundTheShapeAndNowhereElse) {
  const auto d = generated_distance<2>("ellipse/long");
  FieldGrid<2> own(3);
  for (int l = 3; l < 6; ++l) {
    own.distance.compute(own.grid, d, DistanceMethod::exact);
    own.refine(1.5);
  }
  own.distance.compute(own.grid, d, DistanceMethod::exact);
  const double side = own.grid.finest_side();
  for (Index i = 0; i < own.grid.n_nodes(); ++i)
    EXPECT_EQ(own.distance.values()[i], d(own.grid.node_position(i))) << "kept over refinements";
  // What was not split at the last step is too far.
  for (const Index leaf : own.grid.leaves()) {
    if (own.grid.cell(leaf).level != 5) continue;
    for (const Index node : own.grid.cell(leaf).nodes) EXPECT_GT(std::abs(own.distance.values()[node]), 1.5 * 2 * side);
  }
  int n_near = 0, n_far = 0;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int i = 0; i < 20000; ++i) {
    const Vec<2> x(uniform(random), uniform(random));
    const double cells = std::abs(d(x)) / side;
    const bool fine = own.grid.cell(own.grid.locate(x)).level == 6;
    // A corner of the cell of twice the size is nearer than its diagonal.
    const bool near = cells<3 - 2.83, far = cells> 3 + 2.83;
    EXPECT_FALSE(near && !fine);
    EXPECT_FALSE(far && fine);
    n_near += near;
    n_far += far;
  }
  EXPECT_GT(n_near, 50);
  EXPECT_GT(n_far, 1000);
}

template <int Dim>
double mean_error(const std::string& name, FieldInterpolation interpolation, int level) {
  const auto d = generated_distance<Dim>(name);
  const ExperimentOptions o = options(interpolation);
  AtLevel<Dim> at(d, d, o, level);
  const GeometryPair<Dim> geometry = at.fields.geometry(at.grid);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> uniform(0, 1);
  double sum = 0;
  int n = 0;
  while (n < 1000) {
    Vec<Dim> x;
    for (int k = 0; k < Dim; ++k) x[k] = uniform(random);
    const double exact = d(x);
    if (std::abs(exact) > at.grid.finest_side()) continue;
    sum += std::abs(geometry.target.value(x)[0] - exact);
    ++n;
  }
  return sum / n;
}

TEST(ShapeFields, SmoothDistancesAreMuchMoreAccurate) {
  EXPECT_LT(mean_error<2>("circle", FieldInterpolation::smooth, 6),
            0.15 * mean_error<2>("circle", FieldInterpolation::multilinear, 6));
  EXPECT_LT(mean_error<3>("sphere", FieldInterpolation::smooth, 5),
            0.25 * mean_error<3>("sphere", FieldInterpolation::multilinear, 5));
}

// Finest cells of the grid of phi that are nearer to the template than to the reference.
int n_fine_at_template(FieldInterpolation interpolation, RefineWhere refine) {
  const auto d1 = generated_distance<2>("circle"), d2 = generated_distance<2>("ellipse/long");
  const ExperimentOptions o = options(interpolation, refine);
  const AtLevel<2> at(d1, d2, o, 6);
  int n = 0;
  for (const Index leaf : at.grid.leaves()) {
    const Vec<2> x = at.grid.cell_centre(leaf);
    n += at.grid.cell(leaf).level == 6 && std::abs(d1(x)) > 0.1 && std::abs(d2(x)) < 0.01;
  }
  return n;
}

TEST(ShapeFields, TheGridOfPhiIsFineAtTheTemplateOnlyIfAskedForOrNeeded) {
  EXPECT_EQ(n_fine_at_template(FieldInterpolation::smooth, RefineWhere::reference), 0);
  EXPECT_GT(n_fine_at_template(FieldInterpolation::smooth, RefineWhere::both), 5);
  EXPECT_GT(n_fine_at_template(FieldInterpolation::multilinear, RefineWhere::reference), 5);
}

TEST(ShapeFields, OwnGridsAreAheadOfThatOfPhiUpToTheFinestLevel) {
  const auto d = generated_distance<2>("circle");
  ExperimentOptions o = options(FieldInterpolation::smooth);
  o.cascade.max_level = 6;
  for (const int ahead : {0, 2, 9}) {
    o.coefficients.levels_ahead = ahead;
    AtLevel<2> at(d, d, o, 3);
    for (int level = 3; level <= 6; ++level) {
      EXPECT_EQ(at.grid.finest_level(), level);
      const auto geometry = at.fields.geometry(at.grid);
      EXPECT_EQ(geometry.reference.finest_level(), std::min(level + ahead, 6));
      EXPECT_EQ(geometry.target.finest_level(), std::min(level + ahead, 6));
      EXPECT_LT(std::abs(geometry.target.value(Vec<2>(0.5, 0.7))[0] - d(Vec<2>(0.5, 0.7))), 0.05);
      at.fields.refine(at.grid);
      at.fields.compute_distances(at.grid);
    }
  }
}

template <int Dim>
void check_lifetimes(const std::string& name) {
  const auto d = generated_distance<Dim>(name);
  ExperimentOptions o = options(FieldInterpolation::smooth);
  o.cascade.max_level = 5;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<Vec<Dim>> places(300);
  for (auto& x : places)
    for (int k = 0; k < Dim; ++k) x[k] = uniform(random);
  const auto values_at_places = [&](const GeometryPair<Dim>& geometry) {
    std::vector<double> all;
    for (const auto& x : places)
      for (const auto* field : {&geometry.reference, &geometry.target})
        for (const double v : field->value(x)) all.push_back(v);
    return all;
  };
  std::vector<GeometryPair<Dim>> kept;
  std::vector<std::vector<double>> values;
  {
    AtLevel<Dim> at(d, d, o, 3);
    for (int level = 3; level <= 5; ++level) {
      kept.push_back(at.fields.geometry(at.grid));
      values.push_back(values_at_places(kept.back()));
      at.fields.refine(at.grid);
      at.fields.compute_distances(at.grid);
    }
    EXPECT_NE(values[0], values[1]);
    EXPECT_EQ(values[1], values[2]) << "those of the finest level serve twice";
  }
  for (std::size_t l = 0; l < kept.size(); ++l) EXPECT_EQ(values_at_places(kept[l]), values[l]) << l;
}

// Their grids are refined after the first fields and go after the last.
TEST(ShapeFields, SmoothFieldsOutliveTheirGrids) {
  check_lifetimes<2>("ellipse/long");
  check_lifetimes<3>("ellipsoid/long");
}

template <int Dim>
void check_identical(const std::string& name) {
  const auto d = generated_distance<Dim>(name);
  for (const auto interpolation : {FieldInterpolation::smooth, FieldInterpolation::multilinear}) {
    ExperimentOptions o = options(interpolation);
    o.coefficients.levels_ahead = 0;
    AtLevel<Dim> at(d, d, o, 4);
    LevelEnergy<Dim> level(at.grid, at.fields.geometry(at.grid), o);
    TermValues ones, values;
    for (std::size_t t = 0; t < ones.size(); ++t) ones[t] = 1;
    ASSERT_TRUE(level.energy.evaluate(identity_map(at.grid), ones, values, {}));
    EXPECT_GT(level.energy.band().n_active_points(), 100u);
    for (const Term term : {"match"_term, "membrane"_term, "bending"_term, "volume"_term})
      EXPECT_LT(std::abs(values[term]), term == "bending"_term ? 1e-3 : 1e-10)
          << term_names()[static_cast<std::size_t>(term)] << ", " << enum_name(interpolation);
  }
}

// All but the bending term are zero to rounding. There the projected inverse of an interpolated root is not
// quite the inverse of the projected root.
TEST(ShapeFields, IdenticalShapesCostNothing) {
  check_identical<2>("ellipse/long");
  check_identical<3>("ellipsoid/long");
}

}  // namespace
}  // namespace shellmatch
