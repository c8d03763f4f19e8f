#include "matching/report/json_page.h"

#include "matching/progress/linked_libraries.h"
#include "matching/progress/process_info.h"

namespace shellmatch {

namespace {

const char* kind_name(PackedKind kind) {
  switch (kind) {
    case PackedKind::points: return "points";
    case PackedKind::indices: return "indices";
    case PackedKind::numbers: return "numbers";
    case PackedKind::bytes: break;
  }
  return "bytes";
}

Json array_json(const PackedArray& a) {
  return {{"name", a.name},
          {"kind", kind_name(a.kind)},
          {"components", a.n_components},
          {"entries", a.n_entries},
          {"offset", a.offset},
          {"bytes", a.n_bytes},
          {"low", a.low},
          {"step", a.step}};
}

}  // namespace

void add_page_members(Json& page, const std::vector<PackedArray>& arrays, const std::optional<PageView>& view) {
  page["format"] = 1;
  page["program"] = {{"version", program_version()}, {"compiler", compiler_name()}, {"vector_code", vector_code()}};
  page["libraries"] = Json::array();
  for (const LinkedLibrary& library : linked_libraries())
    page["libraries"].push_back({{"name", library.name}, {"version", library.version}});
  if (view)
    page["camera"] = {
        {"target", view->target}, {"up", view->up}, {"backward", view->backward}, {"half_height", view->half_height}};
  page["arrays"] = Json::array();
  for (const PackedArray& array : arrays) page["arrays"].push_back(array_json(array));
}

// Without anything that could end the element around it, or begin a comment there.
std::string element_text(const Json& page) {
  std::string safe;
  for (const char c : page.dump(-1, ' ', false, Json::error_handler_t::replace)) {
    if (c == '<') safe += "\\u003c";
    else safe += c;
  }
  return safe;
}

}  // namespace shellmatch
