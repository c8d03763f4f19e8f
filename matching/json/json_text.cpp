#include "matching/json/json_text.h"

#include <istream>

namespace shellmatch {

std::string json_text(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

Json parse_json(std::istream& in) { return Json::parse(in); }

}  // namespace shellmatch
