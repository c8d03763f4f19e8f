// Input that is damaged, made up or out of any range ends in one line that names it, in moderate time and memory.

#include "tests/apps/cli_harness.h"
#include "tests/matching/output/temporary_folder.h"

#include <fmt/core.h>
#include <gtest/gtest.h>
#include <png.h>
#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <random>

namespace shellmatch {
namespace {

namespace fs = std::filesystem;
using testing::contents_of;
using testing::put;
using testing::TemporaryFolder;

Words match(const std::string& reference, const std::string& out, const Words& more = {}) {
  Words words{"match", reference, "generate:ellipse", "-o", out, "--levels", "3:3"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

// Exit code 2 and one line of text that is fit for a terminal.
std::string refusal(const Words& words, std::chrono::seconds limit = std::chrono::seconds(20)) {
  const ProgramResult result = run_program(words, "", limit);
  EXPECT_FALSE(result.timed_out);
  EXPECT_EQ(result.exit_code, 2) << result.err;
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  for (const char c : result.err) EXPECT_TRUE(c == '\n' || static_cast<unsigned char>(c) >= 32) << int{c};
  EXPECT_LT(result.err.size(), 3000u);
  return result.err;
}

std::string circle(double radius, int n, int n_written) {
  std::string text;
  for (int i = 0; i < n_written; ++i)
    text += fmt::format("{},{}\n", radius * std::cos(2 * M_PI * i / n), radius * std::sin(2 * M_PI * i / n));
  return text;
}

TEST(HostileInput, WhatFollowsTheOptionsIsRefusedAtOnce) {
  const TemporaryFolder tmp;
  for (const std::string text : {"{a: 1},", ",", "[a],", "\"a\",", "{\"threads\": 1},\n", "{threads: 1} ]"}) {
    put(tmp / "x.yaml", text);
    for (const char* command : {"run", "study"}) {
      const std::string told = refusal({command, tmp / "x.yaml", "-o", tmp / "o"}, std::chrono::seconds(5));
      EXPECT_TRUE(has(told, "x.yaml")) << told;
    }
  }
}

TEST(HostileInput, WhatFollowsAValueIsRefused) {
  const TemporaryFolder tmp;
  const std::string told = refusal(match("generate:circle", tmp / "o", {"--set", "solver.fallback=[lbfgs], junk"}));
  EXPECT_TRUE(has(told, "solver.fallback") && has(told, "something follows")) << told;
  EXPECT_EQ(run_program(match("generate:circle", tmp / "o", {"--set", "solver.fallback=[lbfgs]", "-q"})).exit_code, 0);
}

TEST(HostileInput, MessagesShowNoControlCharactersAndAreNotLong) {
  const TemporaryFolder tmp;
  put(tmp / "a.yaml", "a\x1b[31mb: 1\n");
  EXPECT_TRUE(has(refusal({"run", tmp / "a.yaml", "-o", tmp / "o"}), "[31mb"));
  put(tmp / "b.yaml", "threads: " + std::string(400000, 'x') + "\n");
  EXPECT_TRUE(has(refusal({"run", tmp / "b.yaml", "-o", tmp / "o"}), "threads"));
  put(tmp / "c.txt", "0 \x1b]0;title\x07 0.5\n");
  EXPECT_TRUE(has(refusal(match("generate:circle", tmp / "o", {"--set", "input.correspondence=" + tmp / "c.txt"})),
                  "\\x1b]0;"));
  refusal({"inspect", "\x1b[2Jclear\n\x80.ply"});
}

TEST(HostileInput, AByteOrderMarkIsNoPartOfACorrespondence) {
  const TemporaryFolder tmp;
  put(tmp / "c.txt",
      "\xef\xbb\xbf"
      "0 0.5 0.5\n");
  const ProgramResult result =
      run_program(match("generate:circle", tmp / "o", {"-q", "--set", "input.correspondence=" + tmp / "c.txt"}));
  EXPECT_EQ(result.exit_code, 0) << result.err;
}

TEST(HostileInput, PointsWithoutCoordinatesAreRefused) {
  const TemporaryFolder tmp;
  put(tmp / "a.ply",
      std::string("ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty float x\nend_header\n") +
          std::string(4, '\0'));
  EXPECT_TRUE(has(refusal({"inspect", tmp / "a.ply"}), "x, y and z"));
}

TEST(HostileInput, NoiseIsNotCountedToItsLastCrossing) {
  const TemporaryFolder tmp;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(0, 1);
  std::string text;
  for (int i = 0; i < 10000; ++i) text += fmt::format("{},{}\n", number(random), number(random));
  put(tmp / "noise.csv", text);
  const std::string told = refusal({"inspect", tmp / "noise.csv"});
  EXPECT_TRUE(has(told, "more than 1000 places")) << told;
}

TEST(HostileInput, ASmallFileWithALargeImageIsRefused) {
  const TemporaryFolder tmp;
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.format = PNG_FORMAT_GRAY;
  image.width = image.height = 4097;
  const std::vector<png_byte> pixels(PNG_IMAGE_SIZE(image), 0);
  ASSERT_NE(png_image_write_to_file(&image, (tmp / "a.png").c_str(), 0, pixels.data(), 0, nullptr), 0);
  EXPECT_LT(fs::file_size(tmp / "a.png"), 100000u);
  const std::string told = refusal({"inspect", tmp / "a.png"});
  EXPECT_TRUE(has(told, "4097 x 4097 pixels")) << told;
}

TEST(HostileInput, SizesBeyondWhatNumbersHoldAreRefused) {
  const TemporaryFolder tmp;
  for (const double radius : {1e120, 1e-170}) {
    put(tmp / "a.csv", circle(radius, 60, 60));
    EXPECT_TRUE(has(refusal(match(tmp / "a.csv", tmp / "o")), "scale the shape"));
    put(tmp / "a.obj",
        fmt::format("v 0 0 0\nv {0} 0 0\nv 0 {0} 0\nv 0 0 {0}\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n", radius));
    EXPECT_TRUE(has(refusal({"inspect", tmp / "a.obj"}), "scale the shape"));
  }
  put(tmp / "a.csv", circle(1e40, 60, 60));
  EXPECT_EQ(run_program({"inspect", tmp / "a.csv"}).exit_code, 0);
}

TEST(HostileInput, AContourThatIsCutOffIsMentioned) {
  const TemporaryFolder tmp;
  put(tmp / "cut.csv", circle(1, 200, 150));
  put(tmp / "whole.csv", circle(1, 200, 200));
  const ProgramResult cut = run_program({"inspect", tmp / "cut.csv"}),
                      whole = run_program({"inspect", tmp / "whole.csv"});
  EXPECT_EQ(cut.exit_code, 0);
  EXPECT_TRUE(has(cut.out, "ring 1 is closed by a segment of length 1.4")) << cut.out;
  EXPECT_FALSE(has(whole.out, "is closed by")) << whole.out;
}

TEST(HostileInput, PipesAreRefusedAndNotWaitedFor) {
  const TemporaryFolder tmp;
  for (const char* name : {"pipe.ply", "pipe.csv", "pipe.vtu", "pipe.txt"})
    ASSERT_EQ(mkfifo((tmp / name).c_str(), 0600), 0);
  const auto brief = std::chrono::seconds(5);
  EXPECT_TRUE(has(refusal({"inspect", tmp / "pipe.ply"}, brief), "pipe"));
  EXPECT_TRUE(has(refusal(match(tmp / "pipe.csv", tmp / "o"), brief), "pipe"));
  EXPECT_TRUE(
      has(refusal(match("generate:circle", tmp / "o", {"--set", "input.correspondence=" + tmp / "pipe.txt"}), brief),
          "pipe"));
  EXPECT_TRUE(has(refusal({"apply", tmp / "pipe.vtu", tmp / "pipe.csv", "-o", tmp / "b.csv"}, brief), "no file"));
  EXPECT_TRUE(has(refusal({"generate", "sphere", "-o", tmp / "pipe.ply", "--force"}, brief), "pipe"));
  put(tmp / "study.yaml",
      "version: 1\nproblems: {a: {set: {input: {reference: pipe.csv, template: 'generate:ellipse'}}}}\nsolvers: "
      "[newton]\n");
  EXPECT_TRUE(has(refusal({"study", tmp / "study.yaml", "-o", tmp / "s"}, brief), "no file"));
}

// A file of options may be a pipe, as in `shellmatch run <(sed ...)`; while it is awaited, one signal ends the program.
TEST(HostileInput, OneSignalEndsTheWaitForAPipe) {
  const TemporaryFolder tmp;
  ASSERT_EQ(mkfifo((tmp / "pipe.yaml").c_str(), 0600), 0);
  Program program({"run", tmp / "pipe.yaml", "-o", tmp / "o"});
  usleep(300000);
  program.send_signal(SIGTERM);
  const ProgramResult result = program.wait(std::chrono::seconds(5));
  EXPECT_FALSE(result.timed_out);
  EXPECT_EQ(result.exit_code, 128 + SIGTERM);
}

TEST(HostileInput, AGridThatCannotFitIsRefusedBeforeStartsAreTriedOnIt) {
  const TemporaryFolder tmp;
  const auto begin = std::chrono::steady_clock::now();
  const ProgramResult result =
      run_program({"match", "generate:sphere", "generate:ellipsoid", "-o", tmp / "o", "--levels", "12:12"});
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20));
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_TRUE(has(result.err, "level 12 needs about")) << result.err;
  EXPECT_FALSE(has(result.err, "--levels 11:11")) << "that does not fit either: " << result.err;
}

TEST(HostileInput, CurvatureClosesWhatMatchCloses) {
  const TemporaryFolder tmp;
  run_program({"generate", "sphere", "-o", tmp / "s.obj"});
  const std::string whole = contents_of(tmp / "s.obj");
  put(tmp / "open.obj", whole.substr(0, whole.rfind("f ")));
  const Words words{"curvature", tmp / "open.obj", "-o", tmp / "o", "--levels", "2:3", "--set", "pictures=none"};
  const ProgramResult closed = run_program(words);
  EXPECT_EQ(closed.exit_code, 0) << closed.err;
  EXPECT_TRUE(has(closed.err, "open.obj: ")) << "says what it made up: " << closed.err;
  Words strict = words;
  strict.insert(strict.end(), {"--force", "--strict"});
  const ProgramResult refused = run_program(strict);
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_TRUE(has(refused.err, "the surface is open")) << refused.err;
}

TEST(HostileInput, APoseByTooFewLandmarksNamesTheKey) {
  const TemporaryFolder tmp;
  put(tmp / "points.csv", "vertex1,vertex2\n0,0\n1,1\n");
  const ProgramResult result = run_program({"match", "generate:sphere", "generate:sphere", "-o", tmp / "o", "--levels",
                                            "3:3", "--landmarks", tmp / "points.csv", "--align", "landmarks"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_TRUE(has(result.err, "align.mode: landmarks: a pose needs at least 3")) << result.err;
}

}  // namespace
}  // namespace shellmatch
