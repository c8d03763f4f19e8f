#pragma once
/// \file
/// Options described once. An option struct has in-class defaults and one static template `describe`, which
/// names every member with its unit, range and meaning:
///
///     struct RefinementOptions {
///       int min_level = 3;
///       double margin = 0.1;
///       template <class Self, class Visitor>
///       static void describe(Self& self, Visitor& visit) {
///         visit("min_level", self.min_level, {.unit = "level", .min = 1, .max = 15,
///                                             .meaning = "level of the uniform grid the cascade starts from"});
///         visit("margin", self.margin, {.unit = "side of the domain", .min = 0, .max = 0.4, .meaning = "..."});
///       }
///     };
///
/// `Self` is const for those who print and not const for those who read. The visitor is a template over the
/// member's type: bool, int, double, std::string, a described enum (below), std::vector of those, or another
/// described struct, which becomes a YAML section. YAML, `shellmatch config`, error messages and
/// docs/options.md are all made from this one description.

#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace shellmatch {

/// What is known of one option besides its name, type and default.
struct OptionInfo {
  std::string_view unit = "";  ///< "", or for example "length", "level", "seconds"
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool min_excluded = false;  ///< true where the value must be greater than `min`
  std::string_view meaning = "";
};

/// Names of an enum's values: specialise as
/// `template <> struct EnumNames<Kind> { static constexpr std::pair<Kind, std::string_view> names[] = {...}; };`
template <class Enum>
struct EnumNames;

template <class Enum>
std::string_view enum_name(Enum value) {
  for (const auto& [v, name] : EnumNames<Enum>::names)
    if (v == value) return name;
  return "?";
}

/// The word of `candidates` nearest to `word` by edit distance, for "did you mean"; empty if none is near.
std::string nearest_word(std::string_view word, const std::vector<std::string>& candidates);

/// "0 < x <= 1", "x >= 3", "any": the range in words that messages and documentation use.
std::string range_text(const OptionInfo& info);

/// Does the number lie in the range? NaN does not.
bool in_range(double value, const OptionInfo& info);

}  // namespace shellmatch
