#include "matching/json/json_text.h"

#include <algorithm>
#include <cstddef>
#include <istream>
#include <vector>

namespace shellmatch {

std::string json_text(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

// Objects keep their keys in a list, which is searched for each of them. Writing goes down by calls of itself.
Json parse_json(std::istream& in) {
  constexpr std::size_t most_keys = 10000, most_depth = 200;
  std::vector<std::size_t> n_keys;  // of the object whose keys stand at a depth
  return Json::parse(in, [&n_keys](int depth, Json::parse_event_t event, Json&) {
    const auto at = static_cast<std::size_t>(depth);
    if (at > most_depth) throw Json::other_error::create(502, "it is nested too deeply", nullptr);
    if (event == Json::parse_event_t::object_start) {
      n_keys.resize(std::max(n_keys.size(), at + 2));
      n_keys[at + 1] = 0;
    }
    if (event == Json::parse_event_t::key && ++n_keys[at] > most_keys)
      throw Json::other_error::create(501, "an object has too many keys", nullptr);
    return true;
  });
}

}  // namespace shellmatch
