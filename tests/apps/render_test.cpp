// `shellmatch render`: what is asked for is drawn, and what cannot be is refused.

#include "matching/render/canvas/image.h"
#include "tests/apps/cli_harness.h"
#include "tests/matching/output/temporary_folder.h"
#include "tests/matching/render/decoded_animation.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <set>
#include <sstream>

namespace shellmatch {
namespace {

namespace fs = std::filesystem;
using testing::contents_of;
using testing::put;
using testing::TemporaryFolder;

// One run in the plane and one in space for all tests.
struct Render : ::testing::Test {
  void SetUp() override {
    if (tmp != nullptr) return;
    tmp = new TemporaryFolder;  // it is named after a test
    for (const Words& pair : {Words{"generate:circle", "generate:ellipse/long", "plane"},
                              Words{"generate:sphere", "generate:ellipsoid/long", "space"}})
      run_program({"match", pair[0], pair[1], "-o", *tmp / pair[2], "--levels", "2:3", "--align", "none", "--set",
                   "pictures=none", "--set", "report=false", "--set", "input.unit=mm", "-q"});
  }
  static void TearDownTestSuite() { delete tmp; }

  static ProgramResult render(const std::string& folder, const std::string& output, const Words& more = {}) {
    Words words{"render", *tmp / folder, "-o", *tmp / output, "--size", "120", "--force"};
    words.insert(words.end(), more.begin(), more.end());
    return run_program(words);
  }
  static Image drawn(const std::string& folder, const Words& more) {
    const ProgramResult result = render(folder, "picture.png", more);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return read_png(*tmp / "picture.png");
  }
  static inline TemporaryFolder* tmp = nullptr;
};

TEST_F(Render, EveryChoiceIsAnotherPicture) {
  for (const char* folder : {"plane", "space"}) {
    std::set<std::vector<std::uint8_t>> pictures;
    const std::vector<Words> choices = {{},
                                        {"--show", "reference"},
                                        {"--show", "template"},
                                        {"--show", "overlay"},
                                        {"--show", "all"},
                                        {"--color", "distance"},
                                        {"--color", "distortion"},
                                        {"--color", "plain"},
                                        {"--time", "0.5"}};
    for (const Words& more : choices) pictures.insert(drawn(folder, more).pixels);
    EXPECT_EQ(pictures.size(), choices.size()) << folder;
    EXPECT_GT(drawn(folder, {"--show", "all"}).width, 3 * 120);
  }
  EXPECT_NE(drawn("space", {"--azimuth", "0", "--elevation", "0"}).pixels,
            drawn("space", {"--azimuth", "90", "--elevation", "0"}).pixels);
}

// At t = 0 the result is the reference, but for its caption.
TEST_F(Render, TimeBeginsAtTheReference) {
  for (const char* folder : {"plane", "space"}) {
    const Image begin = drawn(folder, {"--time", "0"}), reference = drawn(folder, {"--show", "reference"});
    ASSERT_EQ(begin.width, reference.width);
    const auto above_caption = [](const Image& image) {
      return std::vector<std::uint8_t>(image.pixels.begin(), image.pixels.begin() + 3l * image.width * 130);
    };
    EXPECT_EQ(above_caption(begin), above_caption(reference)) << folder;
  }
}

TEST_F(Render, WritesVectorFormatsWithUnits) {
  ASSERT_EQ(render("plane", "picture.svg", {"--color", "distance"}).exit_code, 0);
  ASSERT_EQ(render("space", "picture.pdf").exit_code, 0);
  EXPECT_TRUE(has(contents_of(*tmp / "picture.svg"), "<svg"));
  const std::string pdf = contents_of(*tmp / "picture.pdf");
  EXPECT_TRUE(pdf.starts_with("%PDF-"));
  ASSERT_EQ(render("space", "picture.pdf").exit_code, 0);
  EXPECT_EQ(contents_of(*tmp / "picture.pdf"), pdf);
}

TEST_F(Render, AnimationsAreNumberedPictures) {
  ASSERT_EQ(render("space", "turn", {"--motion", "turntable", "--frames", "4"}).exit_code, 0);
  std::set<std::string> frames;
  for (const char* name : {"frame_0000.png", "frame_0001.png", "frame_0002.png", "frame_0003.png"})
    frames.insert(contents_of(*tmp / "turn/" + name));
  EXPECT_EQ(frames.size(), 4u);
  EXPECT_FALSE(fs::exists(*tmp / "turn/frame_0004.png"));
  ASSERT_EQ(render("plane", "morph", {"--motion", "morph", "--frames", "3"}).exit_code, 0);
  ASSERT_EQ(render("plane", "end.png").exit_code, 0);
  EXPECT_EQ(contents_of(*tmp / "morph/frame_0002.png"), contents_of(*tmp / "end.png"));
  EXPECT_NE(contents_of(*tmp / "morph/frame_0000.png"), contents_of(*tmp / "end.png"));
}

// At full quality the file has the pixels of the folder.
TEST_F(Render, AnAnimationIsOneFile) {
  for (const auto& [folder, motion] :
       {std::pair{"plane", "morph"}, std::pair{"space", "morph"}, std::pair{"space", "turntable"}}) {
    ASSERT_EQ(
        render(folder, "a.webp", {"--motion", motion, "--frames", "5", "--quality", "100", "--seconds", "2"}).exit_code,
        0);
    ASSERT_EQ(render(folder, "pictures", {"--motion", motion, "--frames", "5"}).exit_code, 0);
    const testing::DecodedAnimation decoded = testing::decoded_animation(contents_of(*tmp / "a.webp"));
    ASSERT_EQ(decoded.pictures.size(), 5u) << folder << " " << motion;
    for (int i = 0; i < 5; ++i)
      EXPECT_EQ(decoded.pictures[i], read_png(*tmp / ("pictures/frame_000" + std::to_string(i) + ".png")))
          << folder << " " << motion << " " << i;
    // A morph rests half a second at either end.
    const bool is_morph = motion == std::string("morph");
    EXPECT_EQ(decoded.ends, (is_morph ? std::vector<int>{900, 1300, 1700, 2100, 3000}
                                      : std::vector<int>{400, 800, 1200, 1600, 2000}));
  }
  ASSERT_EQ(render("plane", "b.webp", {"--motion", "morph", "--frames", "10"}).exit_code, 0);
  EXPECT_EQ(testing::decoded_animation(contents_of(*tmp / "b.webp")).ends.back(), 1400) << "25 a second";
}

TEST_F(Render, AnAnimationIsReplacedByForceOnly) {
  const std::string place = *tmp / "kept.webp";
  put(place, "mine");
  const Words words{"render", *tmp / "plane", "-o", place, "--size", "60", "--motion", "morph", "--frames", "2"};
  const ProgramResult result = run_program(words);
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_TRUE(has(result.err, "--force")) << result.err;
  EXPECT_EQ(contents_of(place), "mine");
  Words forced = words;
  forced.push_back("--force");
  EXPECT_EQ(run_program(forced).exit_code, 0);
  EXPECT_EQ(testing::decoded_animation(contents_of(place)).pictures.size(), 2u);
}

TEST_F(Render, RefusesWhatCannotBeDrawn) {
  struct Case {
    std::string folder, output;
    Words more;
    std::string words;
  };
  for (const Case& c :
       {Case{"plane", "x.gif", {}, "written as .png, .svg, .pdf"},
        Case{"plane", "x.png", {"--show", "both"}, "result, reference, template, overlay, all"},
        Case{"plane", "x.png", {"--time", "1.5"}, "from 0 to 1"},
        Case{"plane", "x", {"--motion", "turntable"}, "in the plane"},
        Case{"space", "x.png", {"--frames", "3"}, "--motion"}, Case{"space", "x.webp", {}, "--motion"},
        Case{"space", "x.gif", {"--motion", "morph"}, "one file .webp"},
        Case{"space", "x", {"--motion", "morph", "--quality", "50"}, ".webp"},
        Case{"space", "x.png", {"--seconds", "2"}, "--motion"},
        Case{"space", "x.webp", {"--motion", "morph", "--quality", "0"}, "from 1 to 100"},
        Case{"space", "x", {"--motion", "spin"}, "morph or turntable"},
        Case{"space", "x.png", {"--elevation", "nan"}, "from -90 to 90"}, Case{"nothing", "x.png", {}, "nothing"}}) {
    const ProgramResult result = render(c.folder, c.output, c.more);
    EXPECT_EQ(result.exit_code, 2) << c.words;
    EXPECT_TRUE(has(result.err, c.words)) << result.err;
    EXPECT_FALSE(fs::exists(*tmp / c.output));
  }
}

TEST_F(Render, AnAnimationLargerThanTheFormatIsRefusedBeforeItIsDrawn) {
  const ProgramResult result = run_program(
      {"render", *tmp / "space", "-o", *tmp / "large.webp", "--motion", "morph", "--size", "6000", "--show", "all"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_TRUE(has(result.err, "--size 6000: pictures of an animation end at 16383")) << result.err;
  EXPECT_FALSE(fs::exists(*tmp / "large.webp"));
}

TEST_F(Render, AnAnimationReplacesNoResult) {
  const ProgramResult result = render("space", "plane", {"--motion", "morph", "--frames", "2"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_TRUE(has(result.err, "holds the result of a run")) << result.err;
  EXPECT_TRUE(fs::exists(*tmp / "plane/deformation.vtu"));
}

TEST_F(Render, RefusesAnotherReference) {
  const TemporaryFolder other;
  run_program({"generate", "circle", "-o", other / "a.csv"});
  run_program({"generate", "ellipse", "-o", other / "b.csv"});
  run_program({"match", other / "a.csv", other / "b.csv", "-o", other / "o", "--levels", "3:3", "--align", "none",
               "--set", "pictures=none", "-q"});
  const std::string whole = contents_of(other / "a.csv");
  put(other / "a.csv", "0,0\n1,0\n1,1\n");
  const ProgramResult result = run_program({"render", other / "o", "-o", other / "x.png"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_TRUE(has(result.err, "is no longer the reference")) << result.err;
  // The same number of vertices does not suffice.
  std::istringstream points(whole);
  std::string turned, x, y;
  while (std::getline(points, x, ',') && std::getline(points, y))
    turned += x.starts_with('#') || x == "x" ? "" : fmt::format("{},{}\n", 2 * std::stod(x), y);
  put(other / "a.csv", turned);
  const ProgramResult moved = run_program({"render", other / "o", "-o", other / "x.png"});
  EXPECT_EQ(moved.exit_code, 2);
  EXPECT_TRUE(has(moved.err, "a.csv: has changed since")) << moved.err;
}

// Vertices that were laid on their own limbs lie beside their images (matching/result/own_limb.h).
TEST_F(Render, TakesSomeVerticesThatLieBesideTheirImages) {
  const TemporaryFolder other;
  run_program({"generate", "sphere", "-o", other / "a.obj"});
  run_program({"match", other / "a.obj", "generate:ellipsoid/long", "-o", other / "o", "--levels", "3:3", "--align",
               "none", "--set", "pictures=none", "-q"});
  const std::string whole = contents_of(other / "a.obj");
  const auto rendered = [&](std::size_t every, double factor) {
    std::istringstream lines(whole);
    std::string changed, line;
    for (std::size_t v = 0; std::getline(lines, line);) {
      double x = 0, y = 0, z = 0;
      if (std::sscanf(line.c_str(), "v %lf %lf %lf", &x, &y, &z) == 3 && v++ % every == 0)
        line = fmt::format("v {} {} {}", factor * x, y, z);
      changed += line + '\n';
    }
    put(other / "a.obj", changed);
    return run_program({"render", other / "o", "-o", other / "x.png", "--size", "64", "--force"});
  };
  EXPECT_EQ(rendered(3, 1.05).exit_code, 0);
  for (const auto& [every, factor] : {std::pair{1, 1.05}, std::pair{3, 3.0}})
    EXPECT_TRUE(has(rendered(every, factor).err, "a.obj: has changed since")) << every;
}

}  // namespace
}  // namespace shellmatch
