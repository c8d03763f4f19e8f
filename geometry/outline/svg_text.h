#pragma once
/// \file
/// The texts of SVG's attributes: numbers, lengths, transformations, path data
/// (https://www.w3.org/TR/SVG2/paths.html, 9.3).

#include "geometry/outline/drawn_path.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace shellmatch {

/// A text between the quotes of an attribute, and what to say of it: "drawing.svg: path 'leaf'".
struct SvgText {
  std::string_view text;
  const std::string& place;
};

/// Numbers one by one, of which the next may begin where the last ends: "1.5.5-3".
class SvgNumbers {
 public:
  explicit SvgNumbers(const SvgText& source) : source_(source), rest_(source.text) { skip(); }

  bool at_end() const { return rest_.empty(); }
  char peek() const { return rest_.empty() ? '\0' : rest_.front(); }
  void drop(std::size_t n);
  bool has_number() const;
  /// \throws InputError that names the byte where there is none
  double next();
  Vec<2> next_point();
  /// 0 or 1, after which anything may follow.
  bool next_flag();
  std::string_view rest() const { return rest_; }
  [[noreturn]] void fail(std::string_view expected) const;

 private:
  std::size_t number_length() const;
  void skip();

  const SvgText& source_;
  std::string_view rest_;
};

/// A length with its unit. \param whole what 100 % is \throws InputError where it is none
struct SvgLength {
  double user_units = 0;
  double millimetres = 0;  ///< of mm, cm, in, pt, pc and Q; 0 of others
};
SvgLength svg_length(const SvgText& text, double whole);

inline constexpr double millimetres_per_user_unit = 25.4 / 96;

/// matrix(), translate(), scale(), rotate(), skewX(), skewY(), one after the other.
PlaneMap svg_transform(const SvgText& text);

/// The points of a polygon.
std::vector<Vec<2>> svg_points(const SvgText& text);

/// Path data: M L H V C S Q T A Z, absolute and relative.
std::vector<DrawnPath> svg_paths(const SvgText& text);

}  // namespace shellmatch
