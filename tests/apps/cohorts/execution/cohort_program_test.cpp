// `shellmatch cohort` as a user meets it: what it writes, and what is done again.

#include <algorithm>
#include <cstring>
#include <fstream>
#include <sstream>

#include "tests/apps/cohorts/execution/cohort_harness.h"

namespace shellmatch {
namespace {

namespace fs = std::filesystem;

// How many matchings a command has begun, by what it says.
std::size_t n_begun(const ProgramResult& result) {
  std::size_t n = 0;
  for (std::size_t at = 0; (at = result.err.find(" ...\n", at)) != std::string::npos; ++at) ++n;
  return n;
}

// The head of an array's file, and its values.
struct Npy {
  std::string head;
  std::vector<double> values;
};

Npy parse_npy(const std::string& bytes) {
  const std::size_t n = static_cast<unsigned char>(bytes[8]) + 256u * static_cast<unsigned char>(bytes[9]);
  Npy array{bytes.substr(10, n), std::vector<double>((bytes.size() - 10 - n) / sizeof(double))};
  std::memcpy(array.values.data(), bytes.data() + 10 + n, array.values.size() * sizeof(double));
  return array;
}

TEST_F(CohortProgram, TheMeanOfEllipsesIsTheEllipseOfTheMeanAxes) {
  const std::string file = write_cohort(4, "{kind: mean, rounds: 4}");
  const ProgramResult result = cohort({file, "-o", "out"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(has(result.err, " (1 of 4, about ") && has(result.err, " left)\n") && has(result.err, " (4 of 4)\n"))
      << result.err;
  // Axes 1.02 to 1.08 and .86 to .74.
  const Npy points = parse_npy(text_of("out/model/points.npy"));
  EXPECT_TRUE(has(points.head, "'shape': (4, 51, 2, )")) << points.head;
  // The same numbers as text.
  std::istringstream csv(text_of("out/model/points.csv")), tps(text_of("out/model/points.tps"));
  std::string text;
  std::getline(csv, text);
  EXPECT_EQ(text, "id,point,x,y");
  for (std::size_t k = 0, at = 0; k < 4; ++k) {
    std::getline(tps, text);
    EXPECT_EQ(text, "LM=51");
    for (int p = 0; p < 51; ++p, at += 2) {
      std::getline(tps, text);
      EXPECT_EQ(std::stod(text), points.values[at]);
      EXPECT_EQ(std::stod(text.substr(text.find(' '))), points.values[at + 1]);
      std::string row;
      std::getline(csv, row);
      text[text.find(' ')] = ',';
      EXPECT_EQ(row, "e" + std::to_string(k + 1) + "," + std::to_string(p) + "," + text);
    }
    std::getline(tps, text);
    EXPECT_EQ(text, "ID=e" + std::to_string(k + 1));
  }
  std::ifstream mean(folder_ / "out/model/mean.csv");
  std::string line;
  std::getline(mean, line);
  EXPECT_EQ(line, "x,y,standard_deviation,difference,difference_x,difference_y,t2,p,p_corrected,q");
  double worst = 0, width = 0, height = 0;
  while (std::getline(mean, line)) {
    if (line.empty()) continue;
    const double x = std::stod(line), y = std::stod(line.substr(line.find(',') + 1));
    worst = std::max(worst, std::abs(std::hypot(x / 1.05, y / 0.8) - 1));
    width = std::max(width, x);
    height = std::max(height, y);
  }
  EXPECT_LT(worst, 0.01);
  EXPECT_NEAR(width, 1.05, 0.005);
  EXPECT_NEAR(height, 0.8, 0.005);
  // One mode: the axes depend on one number.
  const std::string modes = csv_lines(text_of("out/model/modes.csv")).at("1");
  EXPECT_GT(std::stod(modes.substr(modes.find(',', modes.find(',') + 1) + 1)), 0.98) << modes;
  EXPECT_TRUE(has(text_of("out/summary.json"), "\"n_matched\": 4")) << text_of("out/summary.json");
  EXPECT_TRUE(has(result.err, "thick and thin: means")) << result.err;
}

TEST_F(CohortProgram, TheStartOfTheSearchDoesNotMatter) {
  const std::string file = write_cohort(4, "{kind: mean, rounds: 6, tolerance: 0.05}");
  const auto mean_of = [&](const std::string& start) {
    EXPECT_EQ(cohort({file, "-o", start, "-q", "--atlas", start}).exit_code, 0);
    return text_of(start + "/summary.json");
  };
  const std::string a = mean_of("e1"), b = mean_of("e4");
  const auto deviation = [](const std::string& summary) {
    return std::stod(summary.substr(summary.find("standard_deviation") + 20));
  };
  EXPECT_NEAR(deviation(a), deviation(b), 0.02 * deviation(a));
}

TEST_F(CohortProgram, ANewSubjectIsMatchedAlone) {
  const std::string file = write_cohort(3, "{kind: given, shape: e1}");
  ASSERT_EQ(n_begun(cohort({file, "-o", "out"})), 3u);
  EXPECT_EQ(n_begun(cohort({file, "-o", "out"})), 0u);
  write_cohort(4, "{kind: given, shape: e1}");
  const ProgramResult more = cohort({file, "-o", "out"});
  EXPECT_EQ(more.exit_code, 0) << more.err;
  EXPECT_EQ(n_begun(more), 1u) << more.err;
  // A file whose contents have changed is another subject.
  write_ellipse("e2.csv", 1.3, 0.7);
  const ProgramResult changed = cohort({file, "-o", "out"});
  EXPECT_EQ(n_begun(changed), 1u) << changed.err;
  EXPECT_TRUE(has(changed.err, "e2 ...")) << changed.err;
}

TEST_F(CohortProgram, FilesAndPatternsNeedNoYaml) {
  write_cohort(3, "{}");
  const ProgramResult result = cohort({"e?.csv", "-o", "out", "--atlas", "e2.csv", "--levels", "3:4", "--set",
                                       "pictures=none", "--set", "statistics.samples=20"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(csv_lines(text_of("out/subjects.csv")).size(), 4u);
  // What is written is a cohort's file that can be run again, from anywhere.
  fs::create_directories(folder_ / "elsewhere");
  const ProgramResult again = run_program({"cohort", "../out/cohort.yaml", "-o", "../out"}, path("elsewhere"));
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(n_begun(again), 0u) << again.err;
}

TEST_F(CohortProgram, AModelOfSomeHasScoresOfAll) {
  const std::string file = write_cohort(5, "{kind: given, shape: e1}");
  const ProgramResult result = cohort({file, "-o", "out", "--set", "statistics.model_subjects=3"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(has(result.err, "those of 3 of the 5 subjects")) << result.err;
  const auto scores = csv_lines(text_of("out/model/scores.csv"));
  EXPECT_EQ(scores.size(), 6u);
  EXPECT_EQ(scores.at("id"), "id,group,mode_1,mode_2");
  // The axes change evenly, and so does the score.
  const auto score = [&](const char* id) {
    const std::string& line = scores.at(id);
    return std::stod(line.substr(line.find(',', line.find(',') + 1) + 1));
  };
  EXPECT_NEAR(score("e3") - score("e2"), (score("e5") - score("e1")) / 4, 0.1 * std::abs(score("e5") - score("e1")));
}

TEST_F(CohortProgram, TheMedoidIsTheMiddleOne) {
  const std::string file = write_cohort(5, "{kind: medoid}");
  ASSERT_EQ(cohort({file, "-o", "out", "-q"}).exit_code, 0);
  EXPECT_TRUE(has(text_of("out/atlas/round_1/round.json"), "\"nearest\": \"e3\""))
      << text_of("out/atlas/round_1/round.json");
  EXPECT_EQ(text_of("out/atlas.csv"), text_of("out/atlas/medoid.csv"));
}

TEST_F(CohortProgram, LandmarksAreCarriedBothWays) {
  write_cohort(2, "{}");
  write("p1.csv", "name,x,y\nright,1.02,0\ntop,0,0.86\n");
  write("p2.csv", "name,x,y\nright,1.04,0\nelsewhere,0,-0.82\n");
  write("table.csv", "file,landmarks\ne1.csv,p1.csv\ne2.csv,p2.csv\n");
  const ProgramResult result = cohort({"cohort.yaml", "-o", "out", "--set", "atlas.kind=given", "--set",
                                       "atlas.shape=e1", "--set", "landmarks=compare"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const std::string carried = text_of("out/landmarks.csv");
  EXPECT_TRUE(has(carried, "id,name,x,y,known_x,known_y,distance\n")) << carried;
  EXPECT_EQ(std::count(carried.begin(), carried.end(), '\n'), 5);
  std::istringstream lines(carried);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("e2,right")) {
      EXPECT_LT(std::stod(line.substr(line.rfind(',') + 1)), 0.02) << line;
    } else if (line.starts_with("e2,top")) {
      EXPECT_TRUE(line.ends_with(",,,")) << line << ": its place on e2 is not known";
    }
  EXPECT_EQ(text_of("out/landmarks.tps").find("LM"), 0u);
  EXPECT_EQ(text_of("out/landmarks.txt").find("[individuals]\n"), 0u);
  const std::string returned = text_of("out/landmarks_on_atlas.csv");
  EXPECT_TRUE(has(returned, "e2,elsewhere,")) << returned;
}

TEST_F(CohortProgram, LandmarksOfDrawingsAreTurnedWithThem) {
  write_cohort(2, "{}");
  write("e1.svg", "<svg><ellipse cx='5' cy='3' rx='1.02' ry='.86'/></svg>");
  write("e2.svg", "<svg><ellipse cx='5' cy='3' rx='1.04' ry='.82'/></svg>");
  write("p1.csv", "name,x,y\nright,6.02,3\nbelow,5,3.86\n");
  write("p2.csv", "name,x,y\nright,6.04,3\nbelow,5,3.82\n");
  write("table.csv", "file,landmarks\ne1.svg,p1.csv\ne2.svg,p2.csv\n");
  const ProgramResult result = cohort({"cohort.yaml", "-o", "out", "--set", "atlas.kind=given", "--set",
                                       "atlas.shape=e1", "--set", "landmarks=compare"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const std::string carried = text_of("out/landmarks.csv");
  EXPECT_TRUE(has(carried, ",5,-3.82,")) << carried;
  std::istringstream lines(carried);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("e2,")) {
      EXPECT_LT(std::stod(line.substr(line.rfind(',') + 1)), 0.02) << line;
    }
}

TEST_F(CohortProgram, LandmarksPullTheMatchingsUnlessTheyAreToBeCompared) {
  write_cohort(2, "{}");
  // e2's 'right' lies 0.2 radians further round than e1's.
  write("p1.csv", "name,x,y\nright,1.02,0\n");
  write("p2.csv", "name,x,y\nright,1.0193,0.1629\nelsewhere,0,-0.82\n");
  write("table.csv", "file,landmarks\ne1.csv,p1.csv\ne2.csv,p2.csv\n");
  const auto distance_with = [&](const std::string& use) {
    EXPECT_EQ(cohort({"cohort.yaml", "-o", use, "-q", "--set", "atlas.kind=given", "--set", "atlas.shape=e1", "--set",
                      "landmarks=" + use})
                  .exit_code,
              0);
    std::istringstream lines(text_of(use + "/landmarks.csv"));
    for (std::string line; std::getline(lines, line);)
      if (line.starts_with("e2,right")) return std::stod(line.substr(line.rfind(',') + 1));
    ADD_FAILURE() << "e2's landmark was not carried";
    return 0.0;
  };
  const double compared = distance_with("compare"), matched = distance_with("match");
  EXPECT_GT(compared, 0.1);
  EXPECT_LT(matched, compared / 2);
}

TEST_F(CohortProgram, AMirroredSubjectIsMatchedAsItsImage) {
  // A triangle without symmetry and its mirror image.
  write("a.csv", "x,y\n0,0\n2,0\n0.3,1\n");
  write("b.csv", "x,y\n0,0\n-0.3,1\n-2,0\n");
  write("table.csv", "file,reflect\na.csv,0\nb.csv,1\n");
  write("cohort.yaml",
        "version: 1\ntable: table.csv\natlas: {kind: given, shape: a}\nset: {pictures: none, report: false, align: "
        "{mode: none}, cascade: {min_level: 3, max_level: 4}}\n");
  ASSERT_EQ(cohort({"cohort.yaml", "-o", "out", "-q"}).exit_code, 0);
  const Npy points = parse_npy(text_of("out/model/points.npy"));
  ASSERT_EQ(points.values.size(), 12u);
  for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(points.values[k], points.values[6 + k], 1e-6);
}

TEST_F(CohortProgram, TheFilesAreTheSameWhateverTheNumberOfJobs) {
  const std::string file = write_cohort(3, "{kind: mean, rounds: 2, tolerance: 0}");
  ASSERT_EQ(cohort({file, "-o", "one", "-q", "--jobs", "1"}).exit_code, 0);
  ASSERT_EQ(cohort({file, "-o", "three", "-q", "--jobs", "3"}).exit_code, 0);
  const auto one = lasting_files("one");
  EXPECT_GT(one.size(), 20u);
  EXPECT_EQ(lasting_files("three"), one);
}

}  // namespace
}  // namespace shellmatch
