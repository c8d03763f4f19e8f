#pragma once
/// \file
/// Colours and colour maps, defined by formulas in the Oklab space (B. Ottosson, 'A perceptual color space
/// for image processing', 2020), in which equal distances are perceived as equal differences.

#include "base/types.h"

namespace shellmatch {

/// An sRGB colour. Components are in [0, 1] and gamma encoded, as stored in a picture.
struct Color {
  double r = 0, g = 0, b = 0;
};

inline constexpr Color white{1, 1, 1};
inline constexpr Color black{0, 0, 0};
inline constexpr Color axis_grey{0.35, 0.37, 0.40};  ///< of axes and labels

/// Conversion of an encoded component to linear light, and back. Both map [0, 1] to itself.
double linear_from_srgb(double c);
double srgb_from_linear(double c);

/// Oklab coordinates (L, a, b); L in [0, 1].
Vec<3> oklab_from_color(const Color& color);

/// The colour with these Oklab coordinates. The chroma is reduced where the colour is outside the gamut of
/// sRGB.
Color color_from_oklab(const Vec<3>& lab);

/// The same from lightness, chroma and hue in degrees.
Color color_from_oklch(double lightness, double chroma, double hue);

/// sequential: from dark violet through teal to light yellow with increasing lightness, for quantities >= 0.
/// diverging: blue, near white, red, for quantities with a neutral middle at t = 1/2.
enum class ColorMap { sequential, diverging };

/// Colour of t, clamped to [0, 1]; NaN is grey. Perceptually uniform in t.
Color map_color(ColorMap map, double t);

/// Colour i of a set of 8 distinguishable colours for line plots; repeats after 8.
Color series_color(int i);

/// A colour of low chroma that encodes a position p in [-1, 1]^3; values outside are clamped.
Color position_color(const Vec<3>& p);

/// a (1 - t) + b t in linear light.
Color mix(const Color& a, const Color& b, double t);

}  // namespace shellmatch
