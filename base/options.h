#pragma once
/// \file
/// Option structs that describe themselves. An option struct has in-class defaults and one static function
/// template `describe`, which gives the name, unit, range and meaning of every member:
///
///     struct SmoothingOptions {
///       int n_sweeps = 3;
///       double margin = 0.1;
///       static void describe(auto& self, auto& visit) {
///         visit("n_sweeps", self.n_sweeps, {.unit = "sweeps", .min = 1, .max = 15,
///                                           .meaning = "sweeps over all vertices"});
///         visit("margin", self.margin, {.unit = "side of the domain", .min = 0, .max = 0.4, .meaning = "..."});
///       }
///     };
///
/// A member that `describe` leaves out is a constant of the method: programs and tests may vary it, files may not.
///
/// `self` is const for visitors that print and not const for visitors that assign. A visitor is a template
/// over the member's type: bool, int, double, std::string, an enum with EnumNames or a Choice (below),
/// std::vector of the first five, or another option struct, which becomes a YAML section. YAML, `shellmatch config`,
/// error messages and docs/options.md are generated from this description.

#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace shellmatch {

/// Description of one option: all but its name, type and default.
struct OptionInfo {
  std::string_view unit = "";  ///< "", or for example "length", "seconds"
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool min_excluded = false;  ///< true where the value must be greater than `min`
  std::string_view meaning = "";
};

/// Names of an enum's values. Specialise as `template <> struct EnumNames<Kind> {
/// static constexpr std::pair<Kind, std::string_view> names[] = {...}; };`
template <class Enum>
struct EnumNames;

template <class Enum>
std::string_view enum_name(Enum value) {
  for (const auto& [v, name] : EnumNames<Enum>::names)
    if (v == value) return name;
  return "?";
}

/// One of several names that are no enum's, such as the models of an energy term. The first is the default.
class Choice {
 public:
  Choice() = default;
  explicit Choice(std::vector<std::string_view> names) : names_(std::move(names)) {}

  const std::vector<std::string_view>& names() const { return names_; }
  std::size_t index() const { return index_; }
  std::string_view name() const { return names_.empty() ? std::string_view{} : names_[index_]; }
  /// \pre `name` is one of names()
  Choice& operator=(std::string_view name);
  friend bool operator==(const Choice& choice, std::string_view name) { return choice.name() == name; }

 private:
  std::vector<std::string_view> names_;
  std::size_t index_ = 0;
};

/// The word of `candidates` with the least edit distance to `word`, for "did you mean"; empty if none is
/// close.
std::string nearest_word(std::string_view word, const std::vector<std::string>& candidates);

/// The range as messages and documentation state it: "0 < x <= 1", "x >= 3", "any".
std::string range_text(const OptionInfo& info);

/// True if the number lies in the range. NaN does not.
bool in_range(double value, const OptionInfo& info);

}  // namespace shellmatch
