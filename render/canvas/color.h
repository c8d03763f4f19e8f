#pragma once
/// \file
/// Colours and colour maps, all made by formula in the Oklab space (B. Ottosson, 'A perceptual color space
/// for image processing', 2020), where equal distances look equally different.

#include "base/types.h"

namespace shellmatch {

/// An sRGB colour; components in [0, 1] as they are stored in a picture (gamma encoded).
struct Color {
  double r = 0, g = 0, b = 0;
};

inline constexpr Color white{1, 1, 1};
inline constexpr Color black{0, 0, 0};

/// Linear light of an encoded component, and back. Both map [0, 1] to itself.
double linear_from_srgb(double c);
double srgb_from_linear(double c);

/// Oklab coordinates (L, a, b); L in [0, 1].
Vec<3> oklab_from_color(const Color& color);

/// The colour of Oklab coordinates; chroma is lowered where the colour does not exist in sRGB.
Color color_from_oklab(const Vec<3>& lab);

/// The same from lightness, chroma and hue in degrees.
Color color_from_oklch(double lightness, double chroma, double hue);

/// sequential: from dark violet over teal to light yellow, lightness rising, for quantities >= 0.
/// diverging: blue, near white, red, for quantities with a neutral middle at t = 1/2.
enum class ColorMap { sequential, diverging };

/// Colour of t, clamped to [0, 1]; NaN is grey. Steps of equal length in t look equally large.
Color map_color(ColorMap map, double t);

/// Colour i of a set that is told apart well in line plots; repeats after 8.
Color series_color(int i);

/// A soft colour that tells where a point lies; p in [-1, 1]^3, values outside are clamped.
Color position_color(const Vec<3>& p);

/// a (1 - t) + b t in linear light.
Color mix(const Color& a, const Color& b, double t);

}  // namespace shellmatch
