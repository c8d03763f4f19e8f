#include "matching/experiment/level_overrides.h"

#include "base/error.h"

#include <algorithm>
#include <charconv>

namespace shellmatch {

namespace {

/// `text` as a level; 0 if it is none.
int parse_level(std::string_view text) {
  int level = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), level);
  const bool good = error == std::errc() && end == text.data() + text.size() && level >= 1 && level <= finest_level;
  return good ? level : 0;
}

}  // namespace

std::string LevelOverrides::Entry::key() const {
  return first == last ? fmt::format("{}", first) : fmt::format("{}-{}", first, last);
}

void LevelOverrides::Entry::set(const std::string& path, std::vector<Value> values) {
  std::erase_if(settings, [&](const auto& s) { return s.first == path; });
  settings.emplace_back(path, std::move(values));
}

LevelOverrides::Entry& LevelOverrides::at(std::string_view key, const std::string& where) {
  const std::size_t dash = key.find('-');
  const int first = parse_level(key.substr(0, dash));
  const int last = dash == std::string_view::npos ? first : parse_level(key.substr(dash + 1));
  if (first == 0 || last == 0 || last < first)
    throw_input_error("{}: '{}' is no range of levels; expected a level from 1 to {}, as 6, or two, as 3-5", where,
                      key.substr(0, 60), finest_level);
  for (Entry& e : entries) {
    if (e.first == first && e.last == last) return e;
    if (first <= e.last && e.first <= last)
      throw_input_error("{}: levels {} and {} overlap; every level may be named once", where, e.key(), key);
  }
  const auto place = std::find_if(entries.begin(), entries.end(), [&](const Entry& e) { return e.first > first; });
  return *entries.insert(place, Entry{first, last, {}});
}

}  // namespace shellmatch
