#include "matching/render/canvas/color.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace shellmatch {

double linear_from_srgb(double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); }
double srgb_from_linear(double c) {
  c = std::clamp(c, 0.0, 1.0);
  return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
}

Vec<3> oklab_from_color(const Color& color) {
  const Vec<3> rgb(linear_from_srgb(color.r), linear_from_srgb(color.g), linear_from_srgb(color.b));
  Mat<3> to_cone, to_lab;
  to_cone << 0.4122214708, 0.5363325363, 0.0514459929, 0.2119034982, 0.6806995451, 0.1073969566, 0.0883024619,
      0.2817188376, 0.6299787005;
  to_lab << 0.2104542553, 0.7936177850, -0.0040720468, 1.9779984951, -2.4285922050, 0.4505937099, 0.0259040371,
      0.7827717662, -0.8086757660;
  const Vec<3> cone = to_cone * rgb;
  return to_lab * Vec<3>(std::cbrt(cone[0]), std::cbrt(cone[1]), std::cbrt(cone[2]));
}

namespace {

Vec<3> linear_rgb(const Vec<3>& lab) {
  Mat<3> to_cone, to_rgb;
  to_cone << 1, 0.3963377774, 0.2158037573, 1, -0.1055613458, -0.0638541728, 1, -0.0894841775, -1.2914855480;
  to_rgb << 4.0767416621, -3.3077115913, 0.2309699292, -1.2684380046, 2.6097574011, -0.3413193965, -0.0041960863,
      -0.7034186147, 1.7076147010;
  const Vec<3> cone = (to_cone * lab).array().cube();
  return to_rgb * cone;
}

bool exists(const Vec<3>& rgb) { return rgb.minCoeff() >= -1e-9 && rgb.maxCoeff() <= 1 + 1e-9; }

using Table = std::array<Color, 257>;

// Samples a curve in Oklab at points of equal distance along it.
template <class Curve>
Table equal_steps(const Curve& curve) {
  constexpr int n_fine = 4096;
  std::vector<Vec<3>> points(n_fine + 1);
  std::vector<double> length(n_fine + 1, 0);
  for (int i = 0; i <= n_fine; ++i) {
    points[i] = oklab_from_color(curve(static_cast<double>(i) / n_fine));
    if (i > 0) length[i] = length[i - 1] + (points[i] - points[i - 1]).norm();
  }
  Table table;
  int i = 0;
  for (std::size_t k = 0; k < table.size(); ++k) {
    const double wanted = length.back() * static_cast<double>(k) / static_cast<double>(table.size() - 1);
    while (i + 1 < n_fine && length[i + 1] < wanted) ++i;
    const double s = std::clamp((wanted - length[i]) / (length[i + 1] - length[i]), 0.0, 1.0);
    table[k] = color_from_oklab((1 - s) * points[i] + s * points[i + 1]);
  }
  return table;
}

const Table& table_of(ColorMap map) {
  static const Table sequential = equal_steps([](double t) {
    return color_from_oklch(0.28 + 0.66 * t, 0.075 + 0.045 * std::sin(std::numbers::pi * t), 305 - 200 * t);
  });
  static const Table diverging = equal_steps([](double t) {
    const double side = std::abs(2 * t - 1);
    return color_from_oklch(0.95 - 0.50 * side, 0.17 * std::pow(side, 0.9), t < 0.5 ? 255 : 25);
  });
  return map == ColorMap::sequential ? sequential : diverging;
}

}  // namespace

Color color_from_oklab(const Vec<3>& lab) {
  Vec<3> rgb = linear_rgb(lab);
  if (!exists(rgb)) {
    double low = 0, high = 1;
    for (int i = 0; i < 30; ++i) {
      const double s = 0.5 * (low + high);
      (exists(linear_rgb({lab[0], s * lab[1], s * lab[2]})) ? low : high) = s;
    }
    rgb = linear_rgb({lab[0], low * lab[1], low * lab[2]});
  }
  return {srgb_from_linear(rgb[0]), srgb_from_linear(rgb[1]), srgb_from_linear(rgb[2])};
}

Color color_from_oklch(double lightness, double chroma, double hue) {
  const double h = hue * std::numbers::pi / 180;
  return color_from_oklab({lightness, chroma * std::cos(h), chroma * std::sin(h)});
}

Color map_color(ColorMap map, double t) {
  if (std::isnan(t)) return {0.6, 0.6, 0.6};
  const Table& table = table_of(map);
  const double x = std::clamp(t, 0.0, 1.0) * static_cast<double>(table.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(x), table.size() - 2);
  const double s = x - static_cast<double>(i);
  const Color &a = table[i], &b = table[i + 1];
  return {(1 - s) * a.r + s * b.r, (1 - s) * a.g + s * b.g, (1 - s) * a.b + s * b.b};
}

Color series_color(int i) {
  // Consecutive hues are far apart; the lightness varies as well, for colour-blind readers.
  static constexpr double hue[] = {255, 35, 150, 325, 85, 200, 0, 290};
  static constexpr double lightness[] = {0.52, 0.66, 0.58, 0.60, 0.74, 0.70, 0.48, 0.42};
  const int k = ((i % 8) + 8) % 8;
  return color_from_oklch(lightness[k], 0.15, hue[k]);
}

Color position_color(const Vec<3>& p) {
  const Vec<3> q = p.cwiseMax(-1.0).cwiseMin(1.0);
  return color_from_oklab({0.74 + 0.10 * q.y(), 0.12 * q.x(), 0.12 * q.z()});
}

Color mix(const Color& a, const Color& b, double t) {
  const auto m = [t](double x, double y) {
    return srgb_from_linear((1 - t) * linear_from_srgb(x) + t * linear_from_srgb(y));
  };
  return {m(a.r, b.r), m(a.g, b.g), m(a.b, b.b)};
}

}  // namespace shellmatch
