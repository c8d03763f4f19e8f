// Pictures: the same shape from every format, which of their pixels are the shape, what is chosen by name, the
// refusals.
#include "geometry/io/read_shape.h"
#include "tests/geometry/io/files.h"
#include "tests/support/picture_files.h"

#include <gtest/gtest.h>
#include <tiffio.h>
#include <turbojpeg.h>

#include <bit>
#include <cmath>

namespace shellmatch::testing {
namespace {

constexpr int width = 60, height = 44;

// A big disc of the label 1 with a small one of the label 2 beside it, on 0; not symmetric in any axis.
int label(int column, int row) {
  if (std::hypot(column + 0.5 - 24, row + 0.5 - 18) < 12) return 1;
  return std::hypot(column + 0.5 - 44, row + 0.5 - 30) < 7 ? 2 : 0;
}
PixelValue labels(std::uint32_t one, std::uint32_t two, std::uint32_t background = 0) {
  return [=](int column, int row) {
    return std::array{background, one, two}[static_cast<std::size_t>(label(column, row))];
  };
}

/// A TIFF structure of a width and an orientation.
std::string exif(int orientation, bool is_big) {
  const auto number = [&](std::uint32_t value, int n) { return is_big ? big(value, n) : little(value, n); };
  const auto entry = [&](std::uint32_t tag, std::uint32_t value) {
    return number(tag, 2) + number(3, 2) + number(1, 4) + number(value, 2) + std::string(2, '\0');
  };
  return (is_big ? "MM" : "II") + number(42, 2) + number(8, 4) + number(2, 2) + entry(0x100, width) +
         entry(0x112, static_cast<std::uint32_t>(orientation));
}

class Pictures : public ::testing::Test {
 protected:
  TempFolder folder_;

  Shape<2> read(const std::string& name, const std::string& bytes, const std::string& choice = "") const {
    return read_outline(folder_.write(name, bytes) + choice);
  }
  std::string error(const std::string& name, const std::string& bytes, const std::string& choice = "") const {
    return input_error_of([&] { read(name, bytes, choice); });
  }
  // Both discs, the first, the second.
  const std::array<Shape<2>, 3> expected_{read("a.png", png_bytes(width, height, 8, labels(255, 255))),
                                          read("a.png", png_bytes(width, height, 8, labels(255, 0))),
                                          read("a.png", png_bytes(width, height, 8, labels(0, 255)))};

  void expect_same(const Shape<2>& shape, int which, const std::string& what) const {
    EXPECT_EQ(shape.surface.vertices, expected_[static_cast<std::size_t>(which)].surface.vertices) << what;
  }
  void expect_labels(const std::string& name, const std::string& bytes, int one, int two) const {
    expect_same(read(name, bytes), 0, name);
    EXPECT_TRUE(has_note(read(name, bytes), "a picture of 2 labels")) << name;
    expect_same(read(name, bytes, ":" + std::to_string(one)), 1, name);
    expect_same(read(name, bytes, ":" + std::to_string(two)), 2, name);
    expect_same(read(name, bytes, fmt::format(":{},{}", one, two)), 0, name);
    expect_same(read(name, bytes, ":>0.5"), 0, name);
    expect_same(read(name, bytes, fmt::format(":>{}", one)), 2, name);
  }
};

TEST_F(Pictures, TheAreaIsThatOfTheDiscs) {
  EXPECT_NEAR(area(expected_[0].surface), std::numbers::pi * (144 + 49), 12);
}

TEST_F(Pictures, LabelsOfEveryFormatAreTheirValues) {
  expect_labels("a.png", png_bytes(width, height, 8, labels(1, 2)), 1, 2);
  expect_labels("a.png", png_bytes(width, height, 16, labels(1, 300)), 1, 300);
  expect_labels("a.png", png_bytes(width, height, 16, labels(600, 60000)), 600, 60000);
  // A dark red and a bright green; the background white: of a palette the index counts.
  expect_labels(
      "a.png",
      png_bytes(width, height, 8, labels(1, 2), "\xff\xff\xff\x50" + std::string(2, '\0') + std::string("\0\xff\0", 3)),
      1, 2);
  expect_labels("a.tif", tiff_bytes(width, height, 8, labels(1, 2)), 1, 2);
  expect_labels("a.TIFF", tiff_bytes(width, height, 16, labels(1, 300)), 1, 300);
  expect_labels("a.tif", tiff_bytes(width, height, 32, labels(7, 70000)), 7, 70000);
  expect_labels("a.tif", tiff_bytes(width, height, 16, labels(7, 700), 2), 7, 700);
  expect_labels("a.tif", tiff_bytes(width, height, 8, labels(1, 2), 1, 3), 1, 2);
  expect_labels("a.tif", tiff_bytes(width, height, 16, labels(1, 300), 1, 1, 16), 1, 300);
  expect_labels(
      "a.tif",
      tiff_bytes(width, height, 32, labels(std::bit_cast<std::uint32_t>(1.0f), std::bit_cast<std::uint32_t>(2.0f)), 3),
      1, 2);
  expect_labels("a.bmp", bmp_bytes(width, height, 8, labels(1, 2)), 1, 2);
  expect_labels("a.bmp", bmp_bytes(width, height, 8, labels(1, 2), 100, true), 1, 2);
}

TEST_F(Pictures, ALabelAloneIsAMaskWhateverItsValue) {
  expect_same(read("a.png", png_bytes(width, height, 16, labels(1, 1))), 0, "1 of 65535");
  expect_same(read("a.tif", tiff_bytes(width, height, 32, labels(3, 3))), 0, "3 of 32 bits");
  const Shape<2> colours = read("a.bmp", bmp_bytes(width, height, 24, labels(0x500000, 0x0000ff)));
  expect_same(colours, 0, "dark red and blue on black");
  EXPECT_TRUE(has_note(colours, "all that is not black"));
}

TEST_F(Pictures, CompressedTilesOfTiffAndItsColours) {
  for (const auto& [colours, orientation] : {std::pair{false, 1}, {true, 1}, {false, 6}, {true, 3}, {true, 6}}) {
    const std::string path = folder_.path("lzw.tif");
    TIFF* const tiff = TIFFOpen(path.c_str(), "w");
    for (const auto& [tag, value] : {std::pair{TIFFTAG_IMAGEWIDTH, width},
                                     {TIFFTAG_IMAGELENGTH, height},
                                     {TIFFTAG_BITSPERSAMPLE, 8},
                                     {TIFFTAG_SAMPLESPERPIXEL, colours ? 3 : 1},
                                     {TIFFTAG_PHOTOMETRIC, colours ? 2 : 1},
                                     {TIFFTAG_ORIENTATION, orientation},
                                     {TIFFTAG_COMPRESSION, 5},
                                     {TIFFTAG_PLANARCONFIG, 1},
                                     {TIFFTAG_PREDICTOR, 2},
                                     {TIFFTAG_TILEWIDTH, 32},
                                     {TIFFTAG_TILELENGTH, 16}})
      TIFFSetField(tiff, static_cast<std::uint32_t>(tag), value);
    for (int top = 0; top < height; top += 16)
      for (int left = 0; left < width; left += 32) {
        std::string tile;
        for (int row = top; row < top + 16; ++row)
          for (int column = left; column < left + 32; ++column)
            tile += std::string(
                colours ? 3 : 1,
                static_cast<char>(row < height && column < width ? label(column, row) * (colours ? 127 : 1) : 0));
        TIFFWriteTile(tiff, tile.data(), static_cast<std::uint32_t>(left), static_cast<std::uint32_t>(top), 0, 0);
      }
    TIFFClose(tiff);
    expect_same(read_outline(path), 0, fmt::format("{}, {}", colours ? "colours" : "labels", orientation));
    EXPECT_EQ(has_note(read_outline(path), "asks for its picture to be shown turned by"), orientation != 1);
    if (!colours) expect_same(read_outline(path + ":2"), 2, "label 2");
    else EXPECT_TRUE(contains(input_error_of([&] { read_outline(path + ":2"); }), "has colours, no labels"));
  }
}

TEST_F(Pictures, AnOrientationIsSaidAndNotFollowed) {
  const std::string plain = png_bytes(width, height, 8, labels(1, 2));
  for (int orientation = 0; orientation <= 9; ++orientation)
    for (const bool is_big : {false, true}) {
      std::string bytes = plain;
      bytes.insert(bytes.find("IDAT") - 4, png_chunk("eXIf", exif(orientation, is_big)));
      const Shape<2> shape = read("a.png", bytes);
      expect_same(shape, 0, "a.png");
      EXPECT_EQ(has_note(shape, fmt::format("(orientation {})", orientation)), orientation > 1 && orientation < 9);
    }
  for (const std::size_t n : {0, 4, 8, 10, 20})
    EXPECT_FALSE(has_note(
        read("a.png", std::string(plain).insert(plain.find("IDAT") - 4, png_chunk("eXIf", exif(6, true).substr(0, n)))),
        "orientation"));
}

TEST_F(Pictures, ExifThatIsNotThereTakesNoMemory) {
  std::string bytes = png_bytes(width, height, 8, labels(1, 2));
  bytes.insert(bytes.find("IDAT") - 4, png_chunk("eXIf", exif(6, true)));
  bytes.replace(bytes.find("eXIf") - 4, 4, big(0x7f000000, 4));
  EXPECT_TRUE(contains(error("a.png", bytes), "cut off or damaged (its EXIF has 2130706432 bytes"));
}

TEST_F(Pictures, JpegIsBrightOrDarkOnItsRim) {
  for (const bool dark : {false, true}) {
    std::string pixels;
    for (int row = 0; row < height; ++row)
      for (int column = 0; column < width; ++column)
        pixels.push_back(static_cast<char>((label(column, row) > 0) != dark ? 230 : 20));
    const tjhandle handle = tjInitCompress();
    unsigned char* data = nullptr;
    unsigned long size = 0;
    ASSERT_EQ(tjCompress2(handle, reinterpret_cast<const unsigned char*>(pixels.data()), width, 0, height, TJPF_GRAY,
                          &data, &size, TJSAMP_GRAY, 90, 0),
              0);
    const std::string bytes(reinterpret_cast<const char*>(data), size);
    tjFree(data);
    tjDestroy(handle);
    const Shape<2> shape = read("photo.jpg", bytes);
    EXPECT_FALSE(has_note(shape, "orientation"));
    const Shape<2> turned = read("phone.jpg", std::string(bytes).insert(2, "\xff\xff\xe1" + big(42, 2) + "Exif" +
                                                                               std::string(2, '\0') + exif(8, true)));
    EXPECT_EQ(turned.surface.vertices, shape.surface.vertices);
    EXPECT_TRUE(has_note(turned, "turned by 90 degrees to the left (orientation 8)"));
    const Shape<2> camera = read("camera.jpg", std::string(bytes).insert(2, 3, 'x'));
    EXPECT_EQ(camera.surface.vertices, shape.surface.vertices);
    EXPECT_TRUE(has_note(camera, "3 bytes between its parts are left out"));
    // What is wrong with the rest is not hidden by them.
    const std::string stray = std::string(bytes).insert(2, 3, 'x');
    EXPECT_THROW(read("cut.jpg", stray.substr(0, stray.size() / 2)), InputError);
    std::string damaged = bytes;
    damaged.replace(bytes.size() - 40, 20, 20, 'x');
    EXPECT_THROW(read("damaged.jpg", damaged), InputError);
    EXPECT_NEAR(area(shape.surface) / area(expected_[0].surface), 1, 0.03);
    EXPECT_TRUE(has_note(shape, dark ? "what is darker than half of white" : "what is brighter than half of white"));
    if (!dark) EXPECT_NEAR(area(read("photo.jpeg", bytes, ":>128").surface) / area(expected_[0].surface), 1, 0.03);
    else EXPECT_TRUE(contains(error("photo.jpeg", bytes, ":>128"), "touches the rim"));
    EXPECT_TRUE(contains(error("photo.jpg", bytes, ":1"), "values that its compression changed, no labels"));
    EXPECT_TRUE(
        contains(error("photo.jpg", bytes.substr(0, bytes.size() / 2)), "the JPEG image is cut off or damaged"));
    EXPECT_TRUE(contains(error("photo.jpg", "no JPEG"), "the JPEG image is cut off or damaged"));
  }
}

TEST_F(Pictures, TheRimShowsTheBackground) {
  const Shape<2> two_tones = read("a.png", png_bytes(width, height, 8, labels(0, 0, 255)));
  expect_same(two_tones, 0, "black on white");
  EXPECT_TRUE(has_note(two_tones, "the dark part is the shape"));
  // With borders of intermediate grey.
  const auto grey = [](bool dark) {
    return [dark](int column, int row) {
      const double inside = std::clamp(12.5 - std::hypot(column + 0.5 - 24, row + 0.5 - 18), 0.0, 1.0);
      return static_cast<std::uint32_t>(std::lround(255 * (dark ? 1 - inside : inside)));
    };
  };
  const Shape<2> bright = read("a.png", png_bytes(width, height, 8, grey(false))),
                 dark = read("a.png", png_bytes(width, height, 8, grey(true)));
  EXPECT_NEAR(area(bright.surface), std::numbers::pi * 144, 3);
  EXPECT_NEAR(area(dark.surface), area(bright.surface), 0.1);
  EXPECT_TRUE(has_note(bright, "a picture of shades")) << "grey along the border is no label";
}

TEST_F(Pictures, ShadesAreNoLabels) {
  // A soft spot: every shade fills 2 x 2 pixels somewhere.
  const Shape<2> spot =
      read("a.png", png_bytes(300, 300, 8, [](int column, int row) {
             return static_cast<std::uint32_t>(std::max(0.0, 255 * (1 - std::hypot(column - 150, row - 150) / 140)));
           }));
  EXPECT_NEAR(area(spot.surface), std::numbers::pi * 70 * 70, 300);
  EXPECT_TRUE(contains(error("a.png", png_bytes(width, height, 16,
                                                [](int column, int row) {
                                                  return static_cast<std::uint32_t>(label(column, row) > 0
                                                                                        ? 200 + 3 * column + row
                                                                                        : 10 + column % 3);
                                                })),
                       "choose a threshold, as in"));
}

TEST_F(Pictures, Refusals) {
  const std::string labelled = png_bytes(width, height, 8, labels(1, 2));
  EXPECT_TRUE(contains(error("a.png", labelled, ":5"),
                       "no pixel is in the shape (label 5); the values are from 0 to 2: 0, 1, 2"));
  EXPECT_TRUE(contains(error("a.png", labelled, ":>-1"), "every pixel is in the shape"));
  EXPECT_TRUE(contains(error("a.png", labelled, ":kidney"), "names no labels; write whole numbers"));
  EXPECT_TRUE(contains(error("a.png", labelled, ":>x"), "is no threshold"));
  EXPECT_TRUE(contains(error("a.png", png_bytes(width, height, 8, labels(9, 9, 9))), "no pixel is brighter"));
  EXPECT_TRUE(contains(error("a.png", png_bytes(width, height, 8, labels(0, 0))), "no pixel is brighter"));
  const std::string tiff = tiff_bytes(width, height, 16, labels(1, 2)), bmp = bmp_bytes(width, height, 8, labels(1, 2));
  EXPECT_TRUE(contains(error("a.tif", tiff.substr(0, 1000)), "the TIFF image is cut off, damaged"));
  EXPECT_TRUE(contains(error("a.tif", "II*"), "the TIFF image is cut off, damaged"));
  EXPECT_TRUE(contains(error("a.tif", tiff_bytes(width, height, 32, labels(0x7fc00000, 1), 3)), "is not finite"));
  EXPECT_TRUE(contains(error("a.tif", tiff_bytes(width, height, 32, labels(1, 20000000))), "number the labels anew"));
  EXPECT_TRUE(contains(error("a.bmp", bmp.substr(0, bmp.size() - 1)), "the BMP image is cut off"));
  EXPECT_TRUE(contains(error("a.bmp", "BM"), "the BMP image is cut off"));
  EXPECT_TRUE(contains(error("a.bmp", labelled), "not a BMP image"));
  std::string huge = bmp, negative = bmp;
  huge.replace(18, 4, little(1 << 30, 4));
  negative.replace(18, 4, little(static_cast<std::uint32_t>(-5), 4));
  EXPECT_TRUE(contains(error("a.bmp", huge), "scale the image"));
  EXPECT_TRUE(contains(error("a.bmp", negative), "-5 x 44 pixels"));
}

}  // namespace
}  // namespace shellmatch::testing
