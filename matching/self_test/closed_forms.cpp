#include "energies/densities/thin_shell.h"
#include "geometry/distance/signed_distance.h"
#include "matching/experiment/generated_source.h"
#include "matching/input/shape_source.h"
#include "matching/experiment/yaml_options.h"
#include "matching/self_test/known_cases.h"
#include "matching/shape_report/curvature_comparison.h"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace shellmatch {

namespace {

template <int Dim>
ExactShape<Dim> formula_of(const std::string& source) {
  return std::get<ExactShape<Dim>>(generated_formula(source).value());
}

// Largest error at random points of the domain, in units of its side. The mesh is inscribed: h^2/8 of its own.
template <int Dim>
SelfCheck check_distance(const std::string& source, double bound) {
  const SignedDistance<Dim> of_mesh(std::get<Shape<Dim>>(open_shape(source)).surface);
  const ExactShape<Dim> exact = formula_of<Dim>(source);
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> in_domain(0, 1);
  double error = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec<Dim> x = Vec<Dim>::NullaryExpr([&] { return in_domain(random); });
    error = std::max(error, std::abs(of_mesh(x) - exact.distance(x)));
  }
  return {"", "distance to " + source, error, bound};
}

// Median error of the curvature of a grid, in units of 1/diagonal.
template <int Dim>
SelfCheck check_curvature(const std::string& source, int level, double bound) {
  const auto shape = std::get<Shape<Dim>>(open_shape(source));
  const ExperimentOptions options = make_experiment(
      {{"cascade.min_level", "3", "self-test"}, {"cascade.max_level", std::to_string(level), "self-test"}});
  const auto found = compare_curvatures<Dim>(shape, formula_of<Dim>(source), options, {}, [](const CurvatureLevel&) {});
  return {"", fmt::format("curvature of {}, level {}", source, level), found.levels.back().to_formula.value().k1.median,
          bound};
}

// W(s R) for a rotation R in space: mu/2 3 s^2 + lambda/4 s^6 + (mu + lambda/2) exp(1 - s^3) - 5 mu/2 - 3 lambda/4, 0
// for s = 1.
SelfCheck check_density() {
  const double lambda = 1.3, mu = 0.7;
  const Material<double> material{lambda, mu, nullptr};
  const Mat<3> rotation = Eigen::AngleAxisd(0.7, Vec<3>(1, 2, 3).normalized()).toRotationMatrix();
  double error = 0;
  for (const double s : {0.5, 1.0, 1.7}) {
    SmallMat<double, 3> a;
    for (int i = 0; i < 9; ++i) a.v[i] = s * rotation(i / 3, i % 3);
    const double expected = s == 1 ? 0
                                   : 1.5 * mu * s * s + 0.25 * lambda * std::pow(s, 6) +
                                         (mu + 0.5 * lambda) * std::exp(1 - s * s * s) - 2.5 * mu - 0.75 * lambda;
    error = std::max(error, std::abs(ThinShellDensity<3>::value<double, double>(a, material) - expected));
  }
  return {"", "density W on multiples of a rotation", error, 1e-14};
}

}  // namespace

std::vector<SelfCheck> check_closed_forms() {
  return {check_density(), check_distance<2>("generate:circle", 1e-5), check_distance<3>("generate:sphere", 2e-4),
          check_curvature<2>("generate:ellipse", 6, 0.04), check_curvature<3>("generate:sphere", 5, 0.06)};
}

}  // namespace shellmatch
