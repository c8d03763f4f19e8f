#include "matching/json/json_text.h"

#include "base/stop.h"

#include <cstddef>
#include <istream>
#include <vector>

namespace shellmatch {

namespace {

// Builds the document and keeps its limits: objects keep their keys in a list, which is searched for each of them, and
// writing goes down by calls of itself. The library's own filter of events asks at the end of each entry about all
// entries of the list around it.
class LimitedBuilder : public nlohmann::detail::json_sax_dom_parser<Json> {
 public:
  using Base = nlohmann::detail::json_sax_dom_parser<Json>;
  explicit LimitedBuilder(Json& document) : Base(document, true) {}

  bool start_object(std::size_t n) {
    enter();
    n_keys_.back() = 0;
    return Base::start_object(n);
  }
  bool start_array(std::size_t n) {
    enter();
    return Base::start_array(n);
  }
  bool end_object() {
    n_keys_.pop_back();
    return Base::end_object();
  }
  bool end_array() {
    n_keys_.pop_back();
    return Base::end_array();
  }
  bool key(std::string& name) {
    constexpr std::size_t most_keys = 10000;
    if (++n_keys_.back() > most_keys) throw Json::other_error::create(501, "an object has too many keys", nullptr);
    return Base::key(name);
  }

 private:
  void enter() {
    constexpr std::size_t most_depth = 200;
    if (n_keys_.size() > most_depth) throw Json::other_error::create(502, "it is nested too deeply", nullptr);
    if (++n_entered_ % 1024 == 0) stop_if_wanted();
    n_keys_.push_back(0);
  }

  std::vector<std::size_t> n_keys_;  // of the objects around
  std::size_t n_entered_ = 0;
};

}  // namespace

std::string json_text(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

Json parse_json(std::istream& in) {
  Json document;
  LimitedBuilder builder(document);
  Json::sax_parse(in, &builder);
  return document;
}

std::string json_bytes(const Json& json) {
  std::string bytes;
  Json::to_cbor(json, bytes);
  return bytes;
}

Json parse_json_bytes(const std::string& bytes) {
  Json document;
  LimitedBuilder builder(document);
  Json::sax_parse(bytes, &builder, Json::input_format_t::cbor);
  return document;
}

}  // namespace shellmatch
