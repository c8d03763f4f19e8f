#include "base/parallel.h"
#include "matching/render/surfaces/surface_paint.h"
#include "matching/render/surfaces/surfaces.h"
#include "tests/matching/render/test_shapes.h"

#include <gtest/gtest.h>

namespace shellmatch {
namespace {

using testing::both;
using testing::cube;
using testing::sphere;

Camera from_front(double half_height) { return {.half_height = half_height}; }

int brightness(const Image& image, int x, int y) { return image.at(x, y)[0] + image.at(x, y)[1] + image.at(x, y)[2]; }

Image draw(const std::vector<RenderSurface>& surfaces, const Camera& camera, int size = 120, bool shade = false) {
  return render_surfaces(surfaces, camera, {.width = size, .height = size, .samples = 2, .ambient_occlusion = shade});
}

// Share of pixels that are not background.
double covered(const Image& image) {
  long n = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) n += brightness(image, x, y) < 600;
  return static_cast<double>(n) / (image.width * image.height);
}

TEST(SurfacesTest, SilhouetteOfASphereHasItsArea) {
  for (const double r : {0.3, 0.8}) {
    const Surface<3> s = sphere(200, r, {0.1, -0.05, 3});
    const Image image = draw({{.surface = &s, .color = black}}, from_front(1), 300);
    EXPECT_NEAR(covered(image), std::numbers::pi * r * r / 4, 0.004 * r);
  }
}

TEST(SurfacesTest, FarFromTheOriginAndInOtherUnitsThePictureIsTheSame) {
  const Surface<3> s = sphere(60, 0.7), cameras_box = s;
  const Surface<3>* near[] = {&s};
  const Image image = draw({{.surface = &s}}, fit_camera(near, 1));
  Surface<3> far = s;
  for (Vec<3>& v : far.vertices) v = 1000 * v + Vec<3>(5e5, -2e5, 1e5);
  const Surface<3>* moved[] = {&far};
  const Image other = draw({{.surface = &far}}, fit_camera(moved, 1));
  long differing = 0;
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    differing += std::abs(int(image.pixels[i]) - int(other.pixels[i])) > 8;
  EXPECT_LT(differing, 30);
}

TEST(SurfacesTest, LooksDrawnTogetherAreThoseDrawnAlone) {
  const Surface<3> s = sphere(40, 0.7), glass = cube(0.5);
  std::vector<std::vector<RenderSurface>> looks(
      2, {{.surface = &s, .paint = Paint::checker}, {.surface = &glass, .opacity = 0.4}});
  looks[1][0].paint = Paint::uniform;
  const RenderOptions options{.width = 90, .height = 70, .samples = 2};
  const std::vector<Image> images = render_looks(looks, from_front(1), options);
  ASSERT_EQ(images.size(), 2u);
  EXPECT_NE(images[0], images[1]);
  for (std::size_t l = 0; l < 2; ++l) EXPECT_EQ(images[l], render_surfaces(looks[l], from_front(1), options)) << l;
}

TEST(SurfacesTest, FittedCameraSeesAllAndFillsThePicture) {
  const Surface<3> a = both(sphere(40, 0.2, {0, 0, 0}), cube(0.3)), b = sphere(40, 0.1, {3, 1, 0.5});
  const Surface<3>* all[] = {&a, &b};
  for (const double field_of_view : {0.0, 20.0, 60.0}) {
    const Camera camera = fit_camera(all, 1.5, {.field_of_view = field_of_view, .margin = 0.05});
    const std::vector<RenderSurface> looks{{.surface = &a, .color = black}, {.surface = &b, .color = black}};
    const Image image =
        render_surfaces(looks, camera, {.width = 300, .height = 200, .samples = 1, .ambient_occlusion = false});
    int left = 300, right = -1, top = 200, bottom = -1;
    for (int y = 0; y < 200; ++y)
      for (int x = 0; x < 300; ++x)
        if (brightness(image, x, y) < 600) {
          left = std::min(left, x);
          right = std::max(right, x);
          top = std::min(top, y);
          bottom = std::max(bottom, y);
        }
    EXPECT_GE(left, 10);
    EXPECT_LE(right, 289);
    EXPECT_GE(top, 5);
    EXPECT_LE(bottom, 194);
    EXPECT_TRUE(right - left > 230 || bottom - top > 150) << right - left << " " << bottom - top;
  }
}

TEST(SurfacesTest, NearerHidesFartherAndTransparencyMixes) {
  const Surface<3> front = sphere(40, 0.5, {0, 0, 2}), back = sphere(40, 0.5, {0, 0, -2});
  const Color red{0.9, 0.1, 0.1}, blue{0.1, 0.1, 0.9};
  RenderSurface f{.surface = &front, .color = red}, b{.surface = &back, .color = blue};
  const auto centre = [&](double opacity) {
    f.opacity = opacity;
    const Image image = draw({b, f}, from_front(1));
    const std::uint8_t* p = image.at(60, 60);
    return std::pair<int, int>(p[0], p[2]);
  };
  const auto [r1, b1] = centre(1);
  const auto [r5, b5] = centre(0.5);
  const auto [r0, b0] = centre(0.001);
  EXPECT_GT(r1, 3 * b1);
  EXPECT_GT(b0, 3 * r0);
  EXPECT_TRUE(r1 > r5 && r5 > r0);
  EXPECT_TRUE(b1 < b5 && b5 < b0);
}

TEST(SurfacesTest, SameBitsWhateverTheNumberOfThreads) {
  const Surface<3> a = sphere(300, 0.8), b = cube(1.2);
  const Surface<3>* all[] = {&a, &b};
  const Camera camera = fit_camera(all, 1);
  const std::vector<RenderSurface> looks{{.surface = &a, .paint = Paint::checker}, {.surface = &b, .opacity = 0.4}};
  const int before = n_threads();
  std::vector<Image> images;
  for (const int n : {1, 2, 2, 4}) {
    set_n_threads(n);
    images.push_back(draw(looks, camera, 160, true));
  }
  set_n_threads(before);
  for (const Image& image : images) EXPECT_EQ(image, images.front());
}

TEST(SurfacesTest, ShadeThatIsKnownGivesTheSamePicture) {
  const Surface<3> hollow = both(sphere(40, 0.8), cube(1.3));
  const Surface<3>* all[] = {&hollow};
  const Camera camera = fit_camera(all, 1);
  const Image own = draw({{.surface = &hollow}}, camera, 120, true);
  EXPECT_EQ(draw({{.surface = &hollow, .openness = surface_openness(hollow)}}, camera, 120, true), own);
  EXPECT_NE(draw({{.surface = &hollow}}, camera), own);
}

TEST(SurfacesTest, LightComesFromTheUpperLeftAndHollowsAreDarker) {
  const Surface<3> s = sphere(80, 0.8);
  const Image ball = draw({{.surface = &s}}, from_front(1));
  EXPECT_GT(brightness(ball, 45, 40), brightness(ball, 75, 85) + 60);

  // A wall right behind the ball: next to it the wall is darker with soft shade, far from it it is not.
  Surface<3> wall;
  for (int j = 0; j <= 40; ++j)
    for (int i = 0; i <= 40; ++i) wall.vertices.push_back({-2 + 0.1 * i, -2 + 0.1 * j, -0.8});
  for (Index j = 0; j < 40; ++j)
    for (Index i = 0; i < 40; ++i) {
      wall.facets.push_back({41 * j + i, 41 * j + i + 1, 41 * j + i + 42});
      wall.facets.push_back({41 * j + i, 41 * j + i + 42, 41 * j + i + 41});
    }
  const std::vector<RenderSurface> looks{{.surface = &s}, {.surface = &wall}};
  const Image plain = draw(looks, from_front(2), 120, false), soft = draw(looks, from_front(2), 120, true);
  EXPECT_LT(brightness(soft, 60, 60 + 26), brightness(plain, 60, 60 + 26) - 25);
  EXPECT_NEAR(brightness(soft, 4, 4), brightness(plain, 4, 4), 6);
}

TEST(SurfacesTest, PatternIsCarriedAlong) {
  const Surface<3> reference = sphere(100, 0.7);
  Surface<3> deformed = reference;
  const Vec<3> shift(0.2, 0.1, -0.3);
  for (Vec<3>& v : deformed.vertices) v += shift;
  Camera camera = from_front(1);
  const Image before = draw({{.surface = &reference, .paint = Paint::checker}}, camera);
  camera.target += shift;
  const Image after = draw({{.surface = &deformed, .paint = Paint::checker, .origins = reference.vertices}}, camera);
  const Image lost = draw({{.surface = &deformed,
                            .paint = Paint::checker,
                            .origins = deformed.vertices,
                            .origin_box = bounding_box(reference.vertices)}},
                          camera);
  const auto differing = [&](const Image& other) {
    long n = 0;
    for (std::size_t i = 0; i < before.pixels.size(); ++i)
      n += std::abs(int(before.pixels[i]) - int(other.pixels[i])) > 40;
    return n;
  };
  EXPECT_LT(differing(after), 60);
  EXPECT_GT(differing(lost), 2000);
}

TEST(SurfacesTest, ScalarsShowTheirColour) {
  const Surface<3> s = sphere(60, 0.8);
  RenderSurface look{.surface = &s, .paint = Paint::scalar, .color_map = ColorMap::diverging};
  for (const Vec<3>& v : s.vertices) look.scalars.push_back(v.x() > 0 ? 1 : 0);
  const Image image = draw({look}, from_front(1));
  EXPECT_GT(image.at(85, 60)[0], image.at(85, 60)[2] + 30);  // red on the right
  EXPECT_LT(image.at(35, 60)[0] + 30, image.at(35, 60)[2]);  // blue on the left
}

TEST(CornerNormalsTest, EdgesStaySharpAndSpheresAreSmooth) {
  const Surface<3> box = cube(1);
  const auto sharp = corner_normals(box, 35), round = corner_normals(box, 120);
  for (std::size_t f = 0; f < box.facets.size(); ++f)
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(sharp[f][k].cwiseAbs().maxCoeff(), 1, 1e-12);
      EXPECT_LT(round[f][k].cwiseAbs().maxCoeff(), 0.95);
      EXPECT_GT(sharp[f][k].dot(box.vertices[box.facets[f][0]]), 0);
    }
  // The normals' error falls at least linearly with the size of the facets.
  double errors[2];
  for (int level = 0; level < 2; ++level) {
    const Surface<3> s = sphere(40 << level, 1);
    const auto normals = corner_normals(s, 35);
    errors[level] = 0;
    for (std::size_t f = 0; f < s.facets.size(); ++f)
      for (int k = 0; k < 3; ++k)
        if (std::abs(s.vertices[s.facets[f][k]].y()) < 0.9)
          errors[level] = std::max(errors[level], (normals[f][k] - s.vertices[s.facets[f][k]]).norm());
  }
  EXPECT_LT(errors[0], 0.05);
  EXPECT_LT(errors[1], 0.6 * errors[0]);
}

}  // namespace
}  // namespace shellmatch
