// Masks: the border of analytic shapes, the axes, the refusals.
#include "geometry/picture/read_mask.h"
#include "geometry/io/read_shape.h"
#include "tests/geometry/io/files.h"

#include <cmath>
#include <functional>
#include <numbers>

namespace shellmatch::testing {
namespace {

// x and y of a pixel's centre as mask_rings counts them.
std::string pgm(int width, int height, const std::function<double(double, double)>& brightness) {
  std::string bytes = fmt::format("P5\n# made\n{} {}\n255\n", width, height);
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
      bytes.push_back(static_cast<char>(std::lround(255 * brightness(column + 0.5, height - row - 0.5))));
  return bytes;
}

Shape<2> mask(const std::string& bytes, const std::string& name = "a.pgm") {
  const TempFolder folder;
  return read_outline(folder.write(name, bytes));
}

double in_disc(double x, double y, double cx, double cy, double r) { return std::hypot(x - cx, y - cy) < r ? 1 : 0; }

TEST(Mask, DiscHasItsAreaItsPlaceAndNoStairs) {
  for (const bool grey : {false, true}) {
    const double r = 30.3, cx = 52.2, cy = 37.9;
    const Shape<2> shape = mask(pgm(110, 80, [&](double x, double y) {
      return grey ? std::clamp(r - std::hypot(x - cx, y - cy) + 0.5, 0.0, 1.0) : in_disc(x, y, cx, cy, r);
    }));
    EXPECT_NEAR(area(shape.surface) / (std::numbers::pi * r * r), 1, 0.01);
    double length = 0, farthest = 0;
    for (const auto& [a, b] : shape.surface.facets) {
      length += (shape.surface.vertices[b] - shape.surface.vertices[a]).norm();
      farthest = std::max(farthest, std::abs((shape.surface.vertices[a] - Vec<2>(cx, cy)).norm() - r));
    }
    // Stairs would be 27 % too long.
    EXPECT_NEAR(length / (2 * std::numbers::pi * r), 1, grey ? 0.002 : 0.01);
    EXPECT_LT(farthest, grey ? 0.1 : 0.7);
    EXPECT_EQ(shape.original.polygons.size(), 1u);
  }
}

TEST(Mask, RingsAreHolesAndSpecksGo) {
  const Shape<2> shape = mask(pgm(120, 120, [](double x, double y) {
    if (std::abs(x - 10) < 1 && std::abs(y - 10) < 1) return 1.0;
    if (x == 3.5 && y == 3.5) return 0.2;  // grey, so that the smoothing is slight and the speck stays
    return in_disc(x, y, 60, 60, 40) - in_disc(x, y, 60, 60, 20);
  }));
  EXPECT_NEAR(area(shape.surface) / (std::numbers::pi * (1600 - 400)), 1, 0.01);
  EXPECT_TRUE(has_note(shape, "1 ring is a hole"));
  EXPECT_TRUE(has_note(shape, "1 ring shorter than 8 pixels"));
}

TEST(Mask, LossOfThinPartsIsSaid) {
  const auto with_line = [](double x, double y) {
    return in_disc(x, y, 30, 30, 15) > 0 || (y > 10 && y < 11 && x > 5 && x < 55) ? 1 : 0;
  };
  EXPECT_TRUE(has_note(mask(pgm(60, 60, with_line)), "changed the area by -"));
  EXPECT_TRUE(mask(pgm(60, 60, [](double x, double y) { return in_disc(x, y, 30, 30, 15); })).notes.empty());
}

// Of two tones the brighter one is the shape: the same to the bit, and no part is said to have gone.
TEST(Mask, TwoTonesNeedNotBeBlackAndWhite) {
  const auto disc = [](double dark, double bright) {
    return mask(pgm(60, 60, [=](double x, double y) { return in_disc(x, y, 30, 30, 15) > 0 ? bright : dark; }));
  };
  const Shape<2> expected = disc(0, 1);
  for (const auto& [dark, bright] : {std::pair{0.0, 0.6}, {0.3, 0.7}, {0.0, 1.0 / 255}, {0.6, 0.9}}) {
    const Shape<2> shape = disc(dark, bright);
    EXPECT_EQ(shape.surface.vertices, expected.surface.vertices) << dark << " " << bright;
    EXPECT_TRUE(shape.notes.empty()) << dark << " " << bright;
  }
  EXPECT_TRUE(contains(input_error_of([&] { disc(0.4, 0.4); }), "no pixel is brighter than half"));
}

// 24 x 24 pixels, a red disc of radius 8 on blue, whose luminances are 0.5 and 0.3.
TEST(Mask, ColoursAreTonesByTheirLuminance) {
  const std::string_view digits =
      "89504e470d0a1a0a0000000d49484452000000180000001808020000006f15aaaf0000003d4944415478da636060f84f2534"
      "220dc2a296548308584da441447983a0412404093d0c22399e460d1a04060dbe7444cd2c42cd4c4bcd6264b4cc464600277d"
      "3ddf84af51630000000049454e44ae426082";
  std::string png;
  for (std::size_t k = 0; k < digits.size(); k += 2)
    png.push_back(static_cast<char>(std::stoi(std::string(digits.substr(k, 2)), nullptr, 16)));
  const GreyImage image = read_png("a.png", png).brightness;
  EXPECT_NEAR(image.at(12, 12), 0.5, 0.01);
  EXPECT_NEAR(image.at(0, 0), 0.3, 0.01);
  const Shape<2> shape = mask(png, "a.png");
  EXPECT_NEAR(area(shape.surface) / 208, 1, 0.02) << "as many pixels are red";
  EXPECT_TRUE(shape.notes.empty());
}

TEST(Mask, TextAndSixteenBitFormsAgree) {
  const auto half_plane = [](int column, int row) { return column > 3 && column < 12 && row > 2 && row < 9; };
  std::string text = "P2 16 12 # comment\n7\n", wide = "P5 16 12 65535\n", narrow = "P5 16 12 1\n";
  for (int row = 0; row < 12; ++row)
    for (int column = 0; column < 16; ++column) {
      text += half_plane(column, row) ? " 7" : "\n0";
      wide += half_plane(column, row) ? "\xFF\xFF" : std::string(2, '\0');
      narrow.push_back(half_plane(column, row) ? 1 : 0);
    }
  const Shape<2> a = mask(text), b = mask(wide), c = mask(narrow);
  EXPECT_EQ(a.surface.vertices, b.surface.vertices);
  EXPECT_EQ(a.surface.vertices, c.surface.vertices);
  // Columns 4 to 11 and rows 3 to 8 from the top of 12.
  const Box<2> box = bounding_box<2>(a.surface.vertices);
  EXPECT_NEAR(box.min.x(), 4, 0.1);
  EXPECT_NEAR(box.max.x(), 12, 0.1);
  EXPECT_NEAR(box.min.y(), 3, 0.1);
  EXPECT_NEAR(box.max.y(), 9, 0.1);
}

// Two squares that touch at a corner: joined where the four pixels around it are bright on the whole.
TEST(Mask, SaddlesAreDecidedByTheirMean) {
  const auto rings = [](double dark, double bright) {
    return mask(pgm(24, 24,
                    [&](double x, double y) {
                      const bool left = x < 12, low = y < 12, corner = std::abs(x - 12) < 1 && std::abs(y - 12) < 1;
                      if (corner) return left == low ? bright : dark;
                      return left == low && x > 2 && x < 22 && y > 2 && y < 22 ? 1.0 : 0.0;
                    }))
        .original.polygons.size();
  };
  EXPECT_EQ(rings(0.3, 1), 1u);
  EXPECT_EQ(rings(0, 0.8), 2u);
}

TEST(Mask, RandomImagesGiveSimpleOutlines) {
  std::uint32_t state = 1;
  for (int trial = 0; trial < 20; ++trial) {
    // Saddles abound here; every ring must be closed and cross no other.
    const Shape<2> shape = mask(pgm(40, 40, [&](double x, double y) {
      state = state * 1664525u + 1013904223u;
      return x < 3 || y < 3 || x > 37 || y > 37 ? 0.0 : (trial % 2 ? (state >> 24) / 255.0 : (state >> 31));
    }));
    EXPECT_GT(area(shape.surface), 0);
  }
}

TEST(Mask, Refusals) {
  const auto message = [](const std::string& bytes, const char* name = "a.pgm") {
    return input_error_of([&] { mask(bytes, name); });
  };
  EXPECT_TRUE(contains(message(pgm(20, 20, [](double, double) { return 0.4; })), "no pixel is brighter than half"));
  EXPECT_TRUE(contains(message(pgm(20, 20, [](double x, double) { return x < 5 ? 1 : 0; })),
                       "touches the rim of the image (28 pixels)"));
  EXPECT_TRUE(contains(message(pgm(20, 20, [](double x, double y) { return in_disc(x, y, 10, 10, 1); })), "too small"));
  const std::string good = pgm(20, 20, [](double x, double y) { return in_disc(x, y, 10, 10, 6); });
  EXPECT_EQ(message(good), "");
  EXPECT_TRUE(
      contains(message(good.substr(0, good.size() - 1)), "cut off: 20 x 20 pixels take 400 bytes, 399 are there"));
  EXPECT_TRUE(contains(message("P5 99999999 99999999 255\n"), "scale the image"));
  EXPECT_TRUE(contains(message("P5 20 20 0\n"), "largest value"));
  EXPECT_TRUE(contains(message("P6 1 1 255\n"), "not a PGM image"));
  EXPECT_TRUE(contains(message("GIF89a, not a PNG image", "a.png"), "damaged"));
}

}  // namespace
}  // namespace shellmatch::testing
