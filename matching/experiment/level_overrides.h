#pragma once
/// \file
/// Options of a section that hold on some levels of the cascade only: `levels: {3-5: {name: lbfgs}, 6: {...}}`.

#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace shellmatch {

/// A member of an option struct next to the options that it overrides.
struct LevelOverrides {
  /// One value; that of a choice is its name.
  using Value = std::variant<bool, int, double, std::string>;

  struct Entry {
    int first = 0, last = 0;  ///< levels, both included
    /// Path within the section ("name", "lbfgs.memory") and value, a list of one where the option is no list.
    std::vector<std::pair<std::string, std::vector<Value>>> settings;

    bool operator==(const Entry&) const = default;
    /// "3-5", or "6"
    std::string key() const;
    /// Sets one value; what was set before for the same path is forgotten.
    void set(const std::string& path, std::vector<Value> values);
  };
  std::vector<Entry> entries;
  bool operator==(const LevelOverrides&) const = default;

  /// The entry with the levels of this key, made where there is none yet. \throws InputError, beginning with `where`,
  /// for a key that is no range of levels 1 to 15, and for one that overlaps with another
  Entry& at(std::string_view key, const std::string& where);
};

}  // namespace shellmatch
