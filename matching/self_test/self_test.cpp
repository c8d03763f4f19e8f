#include "matching/self_test/self_test.h"

#include "energies/densities/thin_shell.h"
#include "geometry/distance/signed_distance.h"
#include "geometry/repair/make_shape.h"
#include "matching/experiment/generated_source.h"
#include "matching/experiment/yaml_options.h"
#include "matching/input/shape_source.h"
#include "matching/match_shapes.h"
#include "matching/run_gradient_check.h"
#include "matching/shape_report/curvature_comparison.h"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace shellmatch {

std::vector<SelfCheck> checks_of(const GradientReport& report) {
  double order_error = 0, functor_error = 0, n_failed = 0;
  for (const TermCheck& term : report.terms) {
    n_failed += term.state == TermCheck::State::failed;
    functor_error = std::max(functor_error, term.gradient_error);
    for (const DirectionCheck& direction : term.directions)
      for (const double order : direction.orders) order_error = std::max(order_error, std::abs(order - 2));
  }
  return {{"", "terms whose derivatives are wrong", n_failed, 0},
          {"", "Taylor remainders: largest deviation from order 2", order_error, 0.05},
          {"", "gradients against dual numbers", functor_error, 1e-11}};
}

template <int Dim>
std::vector<SelfCheck> check_gradients() {
  const bool plane = Dim == 2;
  const ExperimentOptions options =
      make_experiment({{"input.reference", plane ? "generate:circle" : "generate:sphere", "self-test"},
                       {"input.template", plane ? "generate:ellipse" : "generate:ellipsoid", "self-test"},
                       {"cascade.min_level", "3", "self-test"},
                       {"cascade.max_level", plane ? "5" : "3", "self-test"}});
  Observer nobody;
  GradientCheckRequest request;
  request.settings.n_directions = 1;
  request.settings.most_differenced = 100;
  return checks_of(run_gradient_check(options, request, nobody));
}

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

template <>
Similarity<2> self_test_motion<2>() {
  return {.scale = 1.1, .offset = {0.05, 0.1}};
}

template <>
Similarity<3> self_test_motion<3>() {
  return {.scale = 1.1, .offset = {0.05, 0.1, 0}};
}

template <int Dim>
std::vector<SelfCheck> check_match(const Similarity<Dim>& motion, const Similarity<Dim>& truth) {
  const bool plane = Dim == 2;
  const auto reference =
      std::get<OriginalShape<Dim>>(generated_original(plane ? "generate:ellipse" : "generate:ellipsoid"));
  OriginalShape<Dim> moved = reference;
  for (Vec<Dim>& x : moved.vertices) x = motion(x);
  const ExperimentOptions options = make_experiment({{"cascade.min_level", "3", "self-test"},
                                                     {"cascade.max_level", plane ? "6" : "4", "self-test"},
                                                     {"align.mode", "none", "self-test"}});
  Observer nobody;
  const MatchResult<Dim> result =
      match_shapes(make_shape(reference, "the reference"), make_shape(moved, "its image"), options, nobody);
  const double diagonal = bounding_box(reference.vertices).diagonal();
  double worst = 0;
  for (std::size_t i = 0; i < reference.vertices.size(); ++i)
    worst = std::max(worst, (result.deformed.vertices[i] - truth(reference.vertices[i])).norm() / diagonal);
  const TwoSidedDistance distance = result.summary.distance.value();
  const FoldReport& folds = result.summary.levels.back().folds;
  return {{"", "distance from the true positions, largest", worst, plane ? 0.01 : 0.03},
          {"", "distance to the template, mean", distance.deformed_to_template.mean, plane ? 1e-4 : 5e-4},
          {"", "distance from the template, mean", distance.template_to_deformed.mean, plane ? 1e-4 : 5e-4},
          {"", "cells that may fold", static_cast<double>(folds.n_uncertified_cells), 0}};
}

std::vector<SelfCheck> run_self_test(const std::function<void(const std::string& group)>& next) {
  std::vector<SelfCheck> all;
  const auto add = [&](const std::string& group, auto&& checks_of_group) {
    if (next) next(group);
    for (SelfCheck& check : checks_of_group()) {
      check.group = group;
      all.push_back(std::move(check));
    }
  };
  add("closed forms", [] { return check_closed_forms(); });
  add("gradients, 2D", [] { return check_gradients<2>(); });
  add("gradients, 3D", [] { return check_gradients<3>(); });
  add("folds, 2D", [] { return check_fold_certificates<2>(); });
  add("folds, 3D", [] { return check_fold_certificates<3>(); });
  add("match, 2D", [] { return check_match<2>(self_test_motion<2>(), self_test_motion<2>()); });
  add("match, 3D", [] { return check_match<3>(self_test_motion<3>(), self_test_motion<3>()); });
  return all;
}

std::string failed_checks(const std::vector<SelfCheck>& checks) {
  std::string names;
  for (const SelfCheck& check : checks)
    if (!check.passed()) names += fmt::format("{}{}: {}", names.empty() ? "" : ", ", check.group, check.name);
  return names;
}

std::string self_test_text(const std::vector<SelfCheck>& checks) {
  std::string text = fmt::format("{:<16}{:<52}{:>10}{:>10}\n", "", "", "figure", "bound");
  for (const SelfCheck& check : checks)
    text += fmt::format("{:<16}{:<52}{:>10.2e}{:>10.2e}  {}\n", check.group, check.name, check.figure, check.bound,
                        check.passed() ? "ok" : "FAILED");
  return text;
}

SHELLMATCH_2D_3D(check_gradients);
SHELLMATCH_2D_3D(check_match);

}  // namespace shellmatch
