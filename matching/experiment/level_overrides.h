#pragma once
/// \file
/// Options of a section that apply on some levels of the cascade only: `levels: {3-5: {name: lbfgs}, 6: {...}}`.

#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace shellmatch {

/// Its cells have the side 2^-15; about 10^9 of them would meet a surface, which no run gets to.
inline constexpr int finest_level = 15;

/// The overrides of one section; a member of its option struct, beside the options that it overrides.
struct LevelOverrides {
  /// One value; for an enumeration the name of the enumerator.
  using Value = std::variant<bool, int, double, std::string>;

  struct Entry {
    int first = 0, last = 0;  ///< range of levels, both ends included
    /// Path within the section ("name", "lbfgs.memory") and values; a scalar option has one.
    std::vector<std::pair<std::string, std::vector<Value>>> settings;

    bool operator==(const Entry&) const = default;
    /// The range as a key: "3-5", or "6".
    std::string key() const;
    /// Sets the values of one path and replaces earlier ones.
    void set(const std::string& path, std::vector<Value> values);
  };
  std::vector<Entry> entries;
  bool operator==(const LevelOverrides&) const = default;

  /// The entry for the range `key`, created if it is missing. \throws InputError, beginning with `where`, for a key
  /// that is no range of levels 1 to 15 or that overlaps with another one
  Entry& at(std::string_view key, const std::string& where);
};

}  // namespace shellmatch
