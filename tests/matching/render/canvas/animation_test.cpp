// Animations as files: what was put in comes out again.

#include "base/error.h"
#include "matching/render/canvas/animation.h"
#include "tests/matching/render/decoded_animation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace shellmatch {
namespace {

using testing::decoded_animation;
using testing::DecodedAnimation;

// A soft disc that moves before a slope of colours.
Image moving_disc(int frame, int width = 90, int height = 61) {
  Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const double far = std::hypot(x - 20.0 - 3 * frame, y - 30.0), share = 1 / (1 + std::exp(far - 14));
      image.set(x, y, {share + (1 - share) * x / width, 0.4 * share + (1 - share) * y / height, 0.3});
    }
  return image;
}

std::string animation_of(const std::vector<Image>& pictures, int quality, double seconds = 0.04) {
  Animation animation(quality);
  for (const Image& picture : pictures) animation.add(picture, seconds);
  return animation.bytes();
}

double mean_difference(const Image& a, const Image& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) sum += std::abs(a.pixels[i] - b.pixels[i]);
  return sum / a.pixels.size();
}

TEST(Animation, AtFullQualityEveryPixelComesBack) {
  const std::vector<Image> pictures = {moving_disc(0), moving_disc(1), moving_disc(2), moving_disc(7)};
  const DecodedAnimation decoded = decoded_animation(animation_of(pictures, 100));
  EXPECT_EQ(decoded.pictures, pictures);
  EXPECT_EQ(decoded.ends, (std::vector<int>{40, 80, 120, 160}));
  EXPECT_EQ(decoded.n_loops, 0);
}

TEST(Animation, LowerQualityIsShorterAndFartherFromThePictures) {
  std::vector<Image> pictures;
  for (int i = 0; i < 6; ++i) pictures.push_back(moving_disc(i));
  std::vector<double> bytes, differences;
  for (const int quality : {100, 90, 20}) {
    const std::string file = animation_of(pictures, quality);
    const DecodedAnimation decoded = decoded_animation(file);
    ASSERT_EQ(decoded.pictures.size(), pictures.size());
    bytes.push_back(static_cast<double>(file.size()));
    differences.push_back(mean_difference(decoded.pictures.back(), pictures.back()));
  }
  EXPECT_GT(bytes[0], bytes[1]);
  EXPECT_GT(bytes[1], bytes[2]);
  EXPECT_EQ(differences[0], 0);
  EXPECT_LT(differences[1], 3);
  EXPECT_GT(differences[2], differences[1]);
}

// 24 a second are 41.67 ms each: their ends are rounded, not their lengths, so that nothing adds up.
TEST(Animation, TimesAreThoseOfTheSum) {
  std::vector<Image> pictures;
  for (int i = 0; i < 12; ++i) pictures.push_back(moving_disc(i));
  const DecodedAnimation decoded = decoded_animation(animation_of(pictures, 60, 1.0 / 24));
  ASSERT_EQ(decoded.ends.size(), 12u);
  EXPECT_EQ(decoded.ends.front(), 42);
  EXPECT_EQ(decoded.ends.back(), 500);
}

TEST(Animation, APictureThatStaysIsOne) {
  const DecodedAnimation decoded =
      decoded_animation(animation_of({moving_disc(0), moving_disc(3), moving_disc(3)}, 100));
  ASSERT_EQ(decoded.pictures.size(), 2u);
  EXPECT_EQ(decoded.ends, (std::vector<int>{40, 120}));
}

// Nothing of the pictures before is left in one, as where the disc has been.
TEST(Animation, APictureIsTheSameWhateverCameBefore) {
  std::vector<Image> pictures;
  for (int i = 0; i < 12; ++i) pictures.push_back(moving_disc(i));
  EXPECT_EQ(decoded_animation(animation_of(pictures, 60)).pictures.back(),
            decoded_animation(animation_of({moving_disc(0), moving_disc(11)}, 60)).pictures.back());
}

TEST(Animation, TheSamePicturesGiveTheSameBytes) {
  const std::vector<Image> pictures = {moving_disc(0), moving_disc(4)};
  EXPECT_EQ(animation_of(pictures, 90), animation_of(pictures, 90));
}

TEST(Animation, SizesBeyondTheFormatAreRefused) {
  Animation animation(90);
  EXPECT_NO_THROW(Animation(100).add(Image(Animation::largest_side, 2), 1));
  try {
    animation.add(Image(Animation::largest_side + 1, 2), 1);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("16383"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace shellmatch
