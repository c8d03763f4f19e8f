// Where memory is scarce, the program says so and leaves nothing (tests/faults disturbs it in many more ways).
// Sanitizers have memory of their own, so that this file is not built with them.

#include "tests/apps/cli_harness.h"
#include "tests/matching/output/temporary_folder.h"

#include <fmt/core.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <filesystem>

namespace shellmatch {
namespace {

namespace fs = std::filesystem;
using testing::contents_of;
using testing::put;
using testing::TemporaryFolder;

ProgramResult run_with_data(const Words& words, std::size_t bytes) {
  return run_in_child(words, [&] {
    const rlimit limit{bytes, bytes};
    return setrlimit(RLIMIT_DATA, &limit) == 0;
  });
}

class WantOfMemory : public ::testing::TestWithParam<const char*> {};

// From a limit at which nothing begins to one that suffices.
TEST_P(WantOfMemory, EndsInAMessageWhereverItComes) {
  const TemporaryFolder tmp;
  put(tmp / "study.yaml", R"(version: 1
set: {threads: 1, pictures: none, align: {mode: none}, cascade: {min_level: 3, max_level: 3}}
problems: {leaf: {set: {input: {reference: "generate:circle", template: "generate:ellipse"}}}}
solvers: [newton]
)");
  Words words;
  for (std::string_view rest = GetParam(); !rest.empty();) {
    const std::size_t end = std::min(rest.find(' '), rest.size());
    words.emplace_back(rest.substr(0, end) == "STUDY" ? tmp / "study.yaml" : std::string(rest.substr(0, end)));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  // What the libraries need before the program begins is not the program's.
  std::size_t kilobytes = 2000;
  while (run_with_data({"--version"}, 1024 * kilobytes).exit_code != 0) kilobytes += 100;
  int n_refused = 0, n_done = 0;
  for (; kilobytes < 40000 && n_done < 2; kilobytes += 450) {
    SCOPED_TRACE(fmt::format("{} kB", kilobytes));
    Words all = words;
    all.insert(all.end(), {"-q", "-o", tmp / fmt::format("o{}", kilobytes)});
    const ProgramResult result = run_with_data(all, 1024 * kilobytes);
    EXPECT_TRUE(result.exit_code == 0 || result.exit_code == 3 || result.exit_code == 5)
        << result.exit_code << " " << result.err;
    if (result.exit_code != 0) {
      // Fontconfig says something itself before it.
      const std::size_t error = result.err.find("shellmatch: error: ");
      EXPECT_TRUE(error != std::string::npos && result.err.find('\n', error) == result.err.size() - 1) << result.err;
      EXPECT_TRUE(has(result.err, "not enough memory") || has(result.err, "no further thread") ||
                  has(result.err, "Cannot allocate memory"))
          << result.err;
    }
    n_refused += result.exit_code != 0;
    n_done += result.exit_code == 0 && !has(result.err, "is missing");
    const std::string message = contents_of(tmp / fmt::format("o{}/runs/leaf-newton-r1/result.json", kilobytes));
    EXPECT_FALSE(has(message, "crashed")) << message;
  }
  EXPECT_GE(n_refused, 1);
  EXPECT_EQ(n_done, 2);
  for (const fs::directory_entry& entry : fs::directory_iterator(tmp / "."))
    EXPECT_FALSE(entry.path().filename().string().starts_with('.')) << entry.path();
}

INSTANTIATE_TEST_SUITE_P(
    Commands, WantOfMemory,
    ::testing::Values(
        "match generate:circle generate:ellipse --levels 3:4 --align none --set threads=1 --set pictures=result",
        "match generate:circle generate:ellipse --levels 3:4 --align none --set threads=3 --set pictures=none",
        "curvature generate:circle --levels 3:4 --set threads=1", "study STUDY"));

// The factor of a metric is made by a library in C, whose loops ask for threads as well.
TEST(Factor, WantOfMemoryIsALimitWhereTheUserHasSetOne) {
  const TemporaryFolder tmp;
  const Words words{"match",
                    "generate:sphere",
                    "generate:ellipsoid",
                    "--levels",
                    "4:4",
                    "--align",
                    "none",
                    "--set",
                    "solver.name=lbfgs",
                    "--set",
                    "solver.metric=h1",
                    "--set",
                    "solver.fallback=[]",
                    "--set",
                    "solver.stop.max_iterations=1",
                    "--set",
                    "pictures=none",
                    "--threads",
                    "1",
                    "-q",
                    "-o",
                    tmp / "o"};
  // Whether it ends in the factor, with this exit code and text wherever it ends, as the memory grows up to what
  // suffices.
  const auto ends_in_factor = [&](const Words& all, int code, const std::string& text) {
    bool found = false;
    for (std::size_t megabytes = 28; megabytes < 400; megabytes += 4) {
      const ProgramResult result = run_with_data(all, megabytes << 20);
      if (result.exit_code == 0) return found;
      EXPECT_EQ(result.exit_code, code) << megabytes << " MB: " << result.err;
      EXPECT_TRUE(has(result.err, text)) << result.err;
      EXPECT_EQ(tmp.entries(), Words{});
      found =
          found || has(result.err,
                       "there is not enough memory for the factor of the metric on 4913 nodes; use solver.metric l2");
    }
    return false;
  };
  EXPECT_TRUE(ends_in_factor(words, 5, "not enough memory"));
  fs::remove_all(tmp / "o");
  Words limited = words;
  limited.insert(limited.end(), {"--max-memory", "400MB"});
  EXPECT_TRUE(ends_in_factor(limited, 4, "--max-memory 400MB does not suffice"));
}

// With so little memory the ray caster of the pictures cannot begin, or cannot go on.
TEST(RayCaster, WantOfMemoryIsToldAsSuch) {
  const TemporaryFolder tmp;
  const auto run_within = [](rlim_t megabytes, const Words& words) {
    return run_in_child(words, [&] {
      const rlimit limit{megabytes << 20, megabytes << 20};
      return setrlimit(RLIMIT_AS, &limit) == 0;
    });
  };
  rlim_t least = 60;
  while (run_within(least, {"--version"}).exit_code != 0) least += 10;
  std::string told;
  for (rlim_t megabytes = least; megabytes < least + 400; megabytes += 5) {
    // Without alignment, which would need more memory than the ray caster.
    const ProgramResult result =
        run_within(megabytes, {"match", "generate:sphere", "generate:ellipsoid", "-o", tmp / std::to_string(megabytes),
                               "--levels", "2:2", "--align", "none", "--set", "report=false"});
    EXPECT_TRUE(result.exit_code == 0 || result.exit_code == 3 || result.exit_code == 5)
        << megabytes << " MB: " << result.exit_code << " " << result.err;
    EXPECT_FALSE(has(result.err, "Embree error")) << result.err;
    told += result.err;
    if (has(told, "to draw a picture") || (result.exit_code == 0 && !has(result.err, "memory"))) break;
  }
  EXPECT_TRUE(has(told, "not enough memory to draw a picture of surfaces")) << told;
}

}  // namespace
}  // namespace shellmatch
