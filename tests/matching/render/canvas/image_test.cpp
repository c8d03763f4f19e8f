#include "base/error.h"
#include "matching/render/canvas/canvas.h"
#include "matching/render/canvas/panel.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace shellmatch {
namespace {

std::string temporary(const std::string& name) { return ::testing::TempDir() + "shellmatch_image_" + name; }

Image some_picture() {
  Image image(37, 21);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) image.set(x, y, {x / 36.0, y / 20.0, ((x * y) % 7) / 6.0});
  return image;
}

TEST(ImageTest, PngRoundTripIsExact) {
  const std::string path = temporary("round_trip.png");
  write_png(some_picture(), path);
  EXPECT_EQ(read_png(path), some_picture());
  std::filesystem::remove(path);
}

TEST(ImageTest, FullDiskAndMissingFolderAreEnvironmentErrors) {
  if (std::filesystem::exists("/dev/full")) {
    EXPECT_THROW(write_png(some_picture(), "/dev/full"), EnvironmentError);
  }
  EXPECT_THROW(write_png(some_picture(), temporary("no_such_folder/a.png")), EnvironmentError);
}

TEST(ImageTest, ForeignFilesAreInputErrorsThatNameThem) {
  const std::string path = temporary("no_picture.png");
  std::ofstream(path) << "this is no picture";
  try {
    read_png(path);
    FAIL();
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find(path), std::string::npos);
  }
  std::filesystem::remove(path);
  EXPECT_THROW(read_png(path), InputError);
}

TEST(CanvasTest, AnImageIsDrawnWhereItIsPut) {
  Canvas canvas(60, 40);
  const Image picture = some_picture();
  canvas.image(picture, 11, 7);
  const Image result = canvas.to_image();
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      ASSERT_TRUE(std::equal(picture.at(x, y), picture.at(x, y) + 3, result.at(x + 11, y + 7)));
  EXPECT_EQ(*result.at(5, 5), 255);
}

TEST(CanvasTest, TextLeavesInkOnItsSideOfTheAnchor) {
  const auto ink = [](double anchor, int from, int to) {
    Canvas canvas(200, 40);
    canvas.text("level 5", {100, 25}, {.size = 16, .anchor_x = anchor});
    const Image image = canvas.to_image();
    long sum = 0;
    for (int y = 0; y < 40; ++y)
      for (int x = from; x < to; ++x) sum += 255 - *image.at(x, y);
    return sum;
  };
  EXPECT_GT(ink(0, 100, 200), 1000);
  EXPECT_EQ(ink(0, 0, 98), 0);
  EXPECT_GT(ink(1, 0, 100), 1000);
  EXPECT_EQ(ink(1, 102, 200), 0);
}

TEST(PanelTest, HoldsEveryPictureUnchanged) {
  const Image picture = some_picture();
  const std::vector<Panel> panels = {
      {picture, "a", {}}, {picture, "b", ColorBar{.label = "distance"}}, {picture, "", {}}};
  for (const int columns : {0, 2}) {
    const Image all = compose_panels(panels, "title", columns);
    int found = 0;
    for (int y = 0; y + picture.height <= all.height; ++y)
      for (int x = 0; x + picture.width <= all.width; ++x) {
        bool same = true;
        for (int j = 0; same && j < picture.height; ++j)
          same = std::equal(picture.at(0, j), picture.at(0, j) + 3 * picture.width, all.at(x, y + j));
        found += same;
      }
    EXPECT_EQ(found, 3);
  }
}

}  // namespace
}  // namespace shellmatch
