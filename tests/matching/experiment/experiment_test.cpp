// Experiments: what wins over what, and demands between options.

#include "energies/terms/term_names.h"
#include "matching/experiment/level_solver.h"
#include "matching/experiment/yaml_options.h"
#include "tests/support/expect_input_error.h"

#include <filesystem>
#include <fstream>

namespace shellmatch {
namespace {

namespace fs = std::filesystem;

class Experiment : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) /
              (std::string("shellmatch_") + testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string write(const std::string& text) const {
    const std::string path = (folder_ / "experiment.yaml").string();
    std::ofstream(path) << text;
    return path;
  }
  ExperimentOptions read(const std::string& text, const std::vector<std::string>& assignments = {}) const {
    std::vector<Override> overrides;
    for (const std::string& assignment : assignments) overrides.push_back(parse_override(assignment));
    return read_experiment(write(text), overrides);
  }
  void expect_refused(const std::string& text, const std::vector<std::string>& assignments,
                      std::initializer_list<std::string> parts) const {
    expect_input_error([&] { read(text, assignments); }, parts);
  }

  fs::path folder_;
};

TEST_F(Experiment, ProfileIsAppliedBeforeTheOtherKeys) {
  // The key stands before the profile and still wins over it.
  const ExperimentOptions options = read("cascade:\n  nu_substeps: 5\nprofile: paper\n");
  EXPECT_EQ(options.profile, Profile::paper);
  EXPECT_EQ(options.cascade.nu_substeps, 5);
  EXPECT_FALSE(options.coefficients.invert_at_point);
  EXPECT_EQ(read("profile: paper").cascade.nu_substeps, 1);
}

// Its energy is that of the paper, term by term.
TEST_F(Experiment, ProfilePaperHasThePapersTerms) {
  ExperimentOptions paper = read("profile: paper"), standard = read("profile: default");
  EXPECT_EQ(paper.energy.terms.model("membrane"_term), "thin_shell");
  EXPECT_EQ(paper.energy.terms.model("bending"_term), "thin_shell");
  EXPECT_EQ(paper.energy.terms.model("volume"_term), "simplified");
  EXPECT_EQ(standard.energy.terms.model("bending"_term), "extrapolated");
}

TEST_F(Experiment, OverridesWinAndTheLastOneMost) {
  const std::string text = "profile: default\ncascade: {nu: 0.5, max_level: 6}\n";
  const ExperimentOptions options = read(text, {"cascade.nu=0.25", "cascade.nu=0.125", "profile=paper"});
  EXPECT_EQ(options.cascade.nu, 0.125);
  EXPECT_EQ(options.cascade.max_level, 6);
  EXPECT_EQ(options.profile, Profile::paper);
  EXPECT_FALSE(options.coefficients.invert_at_point);
  EXPECT_TRUE(read(text, {"profile=paper", "coefficients.invert_at_point=true"}).coefficients.invert_at_point);
}

TEST_F(Experiment, WrongOverridesNameTheOption) {
  const std::string text = "threads: 1\n";
  expect_refused(text, {"cascade.nuu=1"},
                 {"--set cascade.nuu=1:", "cascade", "unknown key \"nuu\"", "did you mean cascade.nu?"});
  expect_refused(text, {"nu=1"}, {"--set nu=1:", "did you mean cascade.nu?"});
  expect_refused(text, {"cascde.nu=1"}, {"--set cascde.nu=1:", "unknown key"});
  expect_refused(text, {"cascade.nu.x=1"}, {"unknown key"});
  expect_refused(text, {"cascade.nu=much"}, {"--set cascade.nu=much: cascade.nu", "a finite number"});
  expect_refused(text, {"cascade.nu="}, {"cascade.nu", "has no value"});
  expect_refused(text, {"cascade.nu=[1"}, {"--set", "cascade.nu"});
  expect_refused(text, {"cascade=1"}, {"is a section", "cascade.min_level"});
  expect_refused(text, {"cascade.nu"}, {"expected key.sub=value"});
  expect_refused(text, {"=3"}, {"expected key.sub=value"});
  expect_refused(text, {"profile=papr"}, {"did you mean paper?"});
}

TEST_F(Experiment, TextOverridesAreTakenToTheLetter) {
  EXPECT_EQ(read("threads: 1", {"input.reference=a: b #1=2.ply"}).input.reference, "a: b #1=2.ply");
}

TEST_F(Experiment, PathsOfAStudyAreRelativeToItsFileInListsToo) {
  const auto value = [](const char* assignment) {
    return beside_file(parse_override(assignment), "dir/study.yaml").value;
  };
  EXPECT_EQ(value("landmarks.file=points.csv"), "dir/points.csv");
  EXPECT_EQ(value("input.unit=mm"), "mm");
  EXPECT_EQ(value("start.images=[runs/a, '/b, c']"), "['dir/runs/a', '/b, c']");
  ExperimentOptions options = profile_defaults(Profile::standard);
  apply_override(options, beside_file(parse_override("start.images=[\"it's\"]"), "dir/study.yaml"));
  EXPECT_EQ(options.start.images, std::vector<std::string>{"dir/it's"});
}

TEST_F(Experiment, ApplyOverrideChangesOneOption) {
  ExperimentOptions options;
  apply_override(options, "energy.boundary=dirichlet");
  EXPECT_EQ(options.energy.boundary, BoundaryCondition::dirichlet);
  expect_input_error([&] { apply_override(options, "profile=paper"); }, {"--set profile=paper"});
}

TEST_F(Experiment, ShapesAreBesideTheFile) {
  const ExperimentOptions options = read("input:\n  reference: shapes/../a.ply\n  template: /somewhere/b.ply\n");
  EXPECT_EQ(options.input.reference, (folder_ / "a.ply").string());
  EXPECT_EQ(options.input.template_file, "/somewhere/b.ply");
  EXPECT_EQ(read("input: {reference: 'generate:hand'}").input.reference, "generate:hand");
  EXPECT_EQ(read("threads: 1", {"input.reference=a.ply"}).input.reference, "a.ply");
  EXPECT_EQ(read("input: {correspondence: pairs.txt}").input.correspondence, (folder_ / "pairs.txt").string());
  EXPECT_EQ(read("threads: 1").input.correspondence, "");
}

TEST_F(Experiment, AbsolutePathsLeaveBuiltInShapesAlone) {
  ExperimentOptions options;
  options.input.reference = "x/../a.ply";
  options.input.template_file = "generate:hand";
  options = with_absolute_paths(options);
  EXPECT_EQ(options.input.reference, (fs::current_path() / "a.ply").string());
  EXPECT_EQ(options.input.template_file, "generate:hand");
}

TEST_F(Experiment, DemandsBetweenOptionsNameTheLine) {
  expect_refused("cascade:\n  min_level: 5\n  max_level: 4\n", {},
                 {"experiment.yaml:3: cascade.max_level", "4 is below", "cascade.min_level = 5"});
  expect_refused("cascade:\n  max_level: 4\n", {"cascade.min_level=5"}, {"experiment.yaml:2: cascade.max_level"});
  expect_refused("threads: 1", {"cascade.max_level=2"}, {"--set cascade.max_level=2: cascade.max_level"});
  expect_refused("energy:\n  match_weight: 0\n", {}, {"experiment.yaml:2: energy.match_weight"});
  EXPECT_NO_THROW(read("energy: {match_weight: 0}\nlandmarks: {file: points.csv}"));
  expect_refused("solver:\n  name: newtn\n", {}, {"experiment.yaml:2: solver.name", "newtn", "fletcher_reeves"});
  EXPECT_NO_THROW(read("cascade: {min_level: 4, max_level: 4}"));
  EXPECT_NO_THROW(read("energy: {membrane: cauchy_green, bending: quadratic}\nsolver: {name: newton}"));
}

TEST_F(Experiment, SolversOfLevelsAreLaidOverTheSection) {
  const std::string text =
      "solver:\n"
      "  levels:\n"
      "    3-5: {name: lbfgs, lbfgs: {memory: 7}, stop.max_iterations: 9}\n"
      "    6:\n"
      "      metric: h1\n"
      "      fallback: fletcher_reeves\n"
      "  name: newton\n";
  const ExperimentOptions options = read(text, {"solver.levels.6.h1_length=0.25", "solver.levels.8.name=ceres_ncg"});
  for (const ExperimentOptions& o : {options, read(to_yaml(options))}) {
    for (const int level : {3, 5}) {
      const SolverOptions s = solver_at_level(o.solver, level);
      EXPECT_EQ(s.name, "lbfgs");
      EXPECT_EQ(s.lbfgs.memory, 7);
      EXPECT_EQ(s.stop.max_iterations, 9);
      EXPECT_EQ(s.metric, Metric::l2);
    }
    const SolverOptions six = solver_at_level(o.solver, 6);
    EXPECT_EQ(six.name, "newton");
    EXPECT_EQ(six.metric, Metric::h1);
    EXPECT_EQ(six.h1_length, 0.25);
    EXPECT_EQ(six.fallback, std::vector<std::string>{"fletcher_reeves"});
    EXPECT_EQ(solver_at_level(o.solver, 7).name, "newton");
    EXPECT_EQ(solver_at_level(o.solver, 7).lbfgs.memory, LbfgsOptions{}.memory);
    EXPECT_EQ(solver_at_level(o.solver, 8).name, "ceres_ncg");
    EXPECT_EQ(o.solver.levels, options.solver.levels);
  }
}

TEST_F(Experiment, WrongSolversOfLevelsNameTheLine) {
  const auto levels = [](const std::string& text) { return "solver:\n  levels:\n    " + text + "\n"; };
  const std::string place = "experiment.yaml:3: solver.levels";
  expect_refused(levels("3-x: {name: lbfgs}"), {}, {place, "'3-x' is no range of levels", "as 3-5"});
  expect_refused(levels("5-3: {name: lbfgs}"), {}, {place, "'5-3' is no range of levels"});
  expect_refused(levels("0-3: {name: lbfgs}"), {}, {place, "'0-3' is no range of levels"});
  expect_refused(levels("3-5-6: {name: lbfgs}"), {}, {place, "no range of levels"});
  expect_refused(levels("{3-5: {name: lbfgs}, 5-6: {name: lbfgs}}"), {}, {"levels 3-5 and 5-6 overlap"});
  expect_refused(levels("{3: {name: lbfgs}, 3: {name: newton}}"), {}, {place + ".3", "the same key stands in line 3"});
  expect_refused(levels("3-5: {name: lbgfs}"), {}, {place + ".3-5.name", "'lbgfs'", "did you mean 'lbfgs'?"});
  expect_refused(levels("3-5: {fallback: [lbgfs]}"), {}, {place + ".3-5.fallback", "did you mean 'lbfgs'?"});
  expect_refused(levels("3-5: {nmae: lbfgs}"), {}, {place + ".3-5", "unknown key \"nmae\"", "did you mean"});
  expect_refused(levels("3-5: {metric: h2}"), {}, {place + ".3-5.metric", "one of euclidean, l2, h1, h1_band"});
  expect_refused(levels("3-5: {lbfgs: {memory: 0}}"), {}, {place + ".3-5.lbfgs.memory", "out of range"});
  expect_refused(levels("3-5: {lbfgs: 3}"), {}, {place + ".3-5.lbfgs", "is no section"});
  expect_refused(levels("3-5: {levels: {}}"), {}, {"cannot stand within itself"});
  expect_refused(levels("3-5: lbfgs"), {}, {place + ".3-5", "expected options of solver"});
  expect_refused("solver: {levels: lbfgs}", {}, {"experiment.yaml:1: solver.levels", "a map from levels"});
  expect_refused("threads: 1", {"solver.levels.3-5.nme=lbfgs"}, {"--set solver.levels.3-5.nme=lbfgs", "unknown key"});
  expect_refused("threads: 1", {"solver.levels.3-5.name=lbfg"}, {"solver.levels.3-5.name", "did you mean 'lbfgs'?"});
  expect_refused("threads: 1", {"solver.levels=lbfgs"}, {"solver.levels.3-5.name=lbfgs"});
  expect_refused(levels("3-5: {name: lbfgs}"), {"solver.levels.4.name=newton"}, {"levels 3-5 and 4 overlap"});
}

TEST_F(Experiment, RoundTripsExactly) {
  for (const Profile profile : {Profile::standard, Profile::paper}) {
    ExperimentOptions options = profile_defaults(profile);
    options.input.reference = (folder_ / "a \"quoted\" name.ply").string();
    options.input.template_file = "generate:hand/bent";
    options.input.placement = PlacementKind::as_is;
    options.cascade.nu = 0.1 + 0.2;
    options.cascade.volume_factor = 1.0 / 3;
    options.energy.delta = 5e-324;
    options.solver.stop.max_seconds = 1.7976931348623157e308;
    options.threads = 7;
    const std::string text = to_yaml(options);
    const ExperimentOptions again = read(text);
    EXPECT_EQ(to_yaml(again), text);
    EXPECT_EQ(again.cascade.nu, options.cascade.nu);
    EXPECT_EQ(again.cascade.volume_factor, options.cascade.volume_factor);
    EXPECT_EQ(again.energy.delta, options.energy.delta);
    EXPECT_EQ(again.input.reference, options.input.reference);
    EXPECT_EQ(again.profile, profile);
  }
}

}  // namespace
}  // namespace shellmatch
