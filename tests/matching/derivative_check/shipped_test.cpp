// The shipped experiments have right derivatives, and the deformations to check at are what they say.

#include "base/error.h"
#include "energies/assembly/folds.h"
#include "geometry/generate/generate_shape.h"
#include "matching/derivative_check/check_state.h"
#include "matching/run_gradient_check.h"
#include "matching/experiment/yaml_options.h"
#include "matching/input/shape_pair.h"
#include "matching/pair_level.h"
#include "matching/pairs/landmark_file.h"
#include "tests/support/folders.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace shellmatch {
namespace {

TEST(ShippedExperiments, HaveRightDerivatives) {
  Observer silent;
  for (const auto& entry : std::filesystem::directory_iterator(test::source_folder() / "configs")) {
    if (entry.path().extension() != ".yaml") continue;
    SCOPED_TRACE(entry.path());
    const ExperimentOptions options = read_experiment(entry.path().string());
    GradientCheckRequest request;
    request.level = std::max(options.cascade.min_level, 4);
    request.settings = {.n_directions = 1, .seed = 1, .most_differenced = 40, .n_ceres_elements = 2};
    const GradientReport report = run_gradient_check(options, request, silent);
    EXPECT_TRUE(report.passed()) << gradient_report_text(report);
    for (const TermCheck& t : report.terms) {
      const bool acts = t.name != "coverage" || covers(options, *request.level);
      EXPECT_EQ(t.state, acts ? TermCheck::State::passed : TermCheck::State::off) << gradient_report_text(report);
    }
    EXPECT_EQ(report.level, *request.level);
  }
}

/// All experiments, the paper's too, whose shapes come with the program.
std::vector<std::filesystem::path> shipped_experiments() {
  std::vector<std::filesystem::path> found;
  for (const char* folder : {"configs", "configs/paper"})
    for (const auto& entry : std::filesystem::directory_iterator(test::source_folder() / folder))
      if (entry.path().extension() == ".yaml") found.push_back(entry.path());
  return found;
}

// As the command checks, with settings that compare both evaluators.
template <int Dim>
GradientReport compared(PairLevel<Dim>& level, const CheckState& state) {
  const std::vector<Vec<Dim>> phi = positions_of<Dim>(state, level.energy(), level.options().energy, {});
  level.energy().refresh(phi);
  return check_gradient<Dim>(level.energy(), CheckedEnergy<Dim>(level.energy()), phi, level.weights(),
                             {.n_directions = 0, .most_differenced = 1, .n_ceres_elements = 0, .newton_model = false},
                             [](const std::string&) {});
}

/// The shape that an experiment names; built-in surfaces with edges that suit the levels here.
ShapeInput coarse(const std::string& source) {
  ShapeInput input{source};
  const std::string prefix = "generate:";
  if (!source.starts_with(prefix)) return input;
  const std::size_t slash = std::min(source.find('/'), source.size());
  const std::string name = source.substr(prefix.size(), slash - prefix.size());
  const std::string variant = source.substr(std::min(slash + 1, source.size()));
  const AnyOriginal shape = generate_shape(name, variant, 0.02);
  if (const auto* surface = std::get_if<OriginalShape<3>>(&shape)) input.contents = *surface;
  return input;
}

struct Compared {
  CheckState state;
  Evaluator evaluator;
  GradientReport report;
};

// Shapes and levels take longest to make: an experiment's shapes are made once, and one level for each evaluator.
std::vector<Compared> compared(ExperimentOptions options) {
  Observer silent;
  // Shapes that are used as they are may lie beside the outermost cells of level 4, and leave level 3 no room.
  options.cascade.max_level =
      std::max(options.cascade.min_level, options.input.placement == PlacementKind::as_is ? 4 : 3);
  check_experiment(options);
  const auto with_shapes = [&]<int Dim>(const ShapePair<Dim>& shapes) {
    std::vector<Compared> all;
    const auto landmarks = read_landmarks<Dim>(options.landmarks, shapes.reference.original.vertices,
                                               shapes.template_shape.original.vertices, landmark_spaces(shapes));
    for (const Evaluator evaluator : {Evaluator::compiled, Evaluator::ceres}) {
      options.energy.evaluator = evaluator;
      PairLevel<Dim> level(shapes, landmarks, options, options.cascade.max_level, silent);
      for (const char* words : {"identity", "random:0.1"}) {
        const CheckState state = CheckState::parse(words);
        if (evaluator == Evaluator::ceres && state.text() == "identity") continue;
        all.push_back({state, evaluator, compared(level, state)});
      }
    }
    return all;
  };
  const InputOptions& input = options.input;
  return std::visit(with_shapes, open_shape_pair({coarse(input.reference), coarse(input.template_file)}, input,
                                                 options.landmarks, silent));
}

// The two evaluators share the terms' functors and the fields, and no further code: the check's sums are made by Ceres'
// cost functions, whichever of both evaluates the energy.
TEST(ShippedExperiments, HaveTheSameEnergyByBothEvaluators) {
  int n_experiments = 0, n_compared = 0;
  for (const auto& path : shipped_experiments()) {
    std::vector<Compared> all;
    try {
      all = compared(read_experiment(path.string()));
    } catch (const InputError&) {
      continue;  // shapes that do not come with the program
    }
    ++n_experiments;
    for (const auto& [state, evaluator, report] : all) {
      SCOPED_TRACE(path.string() + " " + state.text());
      for (const TermCheck& t : report.terms) {
        // At the identity single terms vanish but for rounding errors, to which their differences would be relative.
        if (t.name != "sum" && state.text() == "identity") continue;
        const double tolerance = t.name == "sum" ? 1e-12 : 1e-11;
        EXPECT_LE(t.value_error, tolerance) << t.name;
        EXPECT_LE(t.gradient_error, tolerance) << t.name;
        EXPECT_EQ(t.element_error == 0, evaluator == Evaluator::ceres || t.n_elements == 0)
            << t.name << ": no code is shared";
        ++n_compared;
      }
    }
  }
  EXPECT_GE(n_experiments, 20);
  EXPECT_GE(n_compared, 240);
}

TEST(CheckStates, AreReadAndNamed) {
  EXPECT_EQ(CheckState::parse("identity").text(), "identity");
  EXPECT_EQ(CheckState::parse("random:0.25:7").text(), "random:0.25:7");
  EXPECT_EQ(CheckState::parse("random:0.25").seed, 1u);
  EXPECT_EQ(CheckState::parse(test::source_folder().string()).kind, CheckState::Kind::folder);
  for (const char* wrong : {"", "idenity", "random", "random:", "random:x", "random:nan", "random:-1", "random:2",
                            "random:0.1:", "random:0.1:-3", "random:0.1:1.5", "random:0.1:1 ", "no/such/folder"})
    EXPECT_THROW(CheckState::parse(wrong), InputError) << wrong;
}

TEST(CheckStates, LevelsOutsideTheCascadeAreRefused) {
  const ExperimentOptions options = read_experiment((test::source_folder() / "configs/leaf.yaml").string());
  Observer silent;
  for (const int level : {1, 3, 11}) {
    GradientCheckRequest request;
    request.level = level;
    EXPECT_THROW(run_gradient_check(options, request, silent), InputError) << level;
  }
}

}  // namespace
}  // namespace shellmatch
