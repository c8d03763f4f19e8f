#include "matching/report/description.h"

#include "matching/experiment/option_text.h"
#include "matching/json/json_members.h"
#include "matching/output/summary.h"
#include "matching/progress/linked_libraries.h"
#include "matching/progress/process_info.h"

#include <sstream>

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
  return {{"name", a.name}, {"kind", kind_name(a.kind)}, {"components", a.n_components}, {"entries", a.n_entries},
          {"offset", a.offset}, {"bytes", a.n_bytes}, {"low", a.low}, {"step", a.step}};
}

std::string any_value_text(const OptionNode& section, const OptionNode& option) {
  return option.level_overrides != nullptr ? level_overrides_text(section, *option.level_overrides) : value_text(option);
}

// All options with their values, and the default where that is another one.
void add_options(Json& list, const OptionNode& section, const OptionNode& defaults) {
  for (std::size_t i = 0; i < section.children.size(); ++i) {
    const OptionNode &option = section.children[i], &usual = defaults.children[i];
    if (option.kind == OptionKind::section) {
      add_options(list, option, usual);
      continue;
    }
    const std::string value = any_value_text(section, option), default_value = any_value_text(defaults, usual);
    Json row = {{"name", option.path}, {"value", value}, {"unit", option.info.unit}, {"meaning", option.info.meaning}};
    if (value != default_value) row["default"] = default_value;
    list.push_back(std::move(row));
  }
}

Json options_json(const ExperimentOptions& options) {
  ExperimentOptions set = options, defaults = profile_defaults(options.profile);
  Json list = Json::array();
  add_options(list, option_tree(set), option_tree(defaults));
  return list;
}

// Without anything that could end the element around it, or begin a comment there.
std::string within_element(std::string text) {
  std::string safe;
  safe.reserve(text.size());
  for (const char c : text) {
    if (c == '<') safe += "\\u003c";
    else safe += c;
  }
  return safe;
}

}  // namespace

std::string report_json(const MatchSummary& summary, const ExperimentOptions& options, const ReportFrame& frame,
                        const std::vector<PackedArray>& arrays) {
  std::istringstream figures(summary_json(summary));
  Json report = {{"format", 1}, {"summary", parse_json(figures)}};
  report["program"] = {{"version", program_version()}, {"compiler", compiler_name()}, {"vector_code", vector_code()}};
  report["libraries"] = Json::array();
  for (const LinkedLibrary& library : linked_libraries()) report["libraries"].push_back({{"name", library.name}, {"version", library.version}});
  report["options"] = options_json(options);
  report["levels"] = frame.levels;
  report["terms"] = frame.term_names;
  report["grid"] = {{"finest_level", frame.grid_level}, {"backward", frame.is_backward}, {"side", frame.domain_side}, {"domain", frame.domain}};
  if (frame.view)
    report["camera"] = {{"target", frame.view->target}, {"up", frame.view->up}, {"backward", frame.view->backward}, {"half_height", frame.view->half_height}};
  if (!frame.picture.empty()) report["picture"] = frame.picture;
  report["arrays"] = Json::array();
  for (const PackedArray& array : arrays) report["arrays"].push_back(array_json(array));
  return within_element(report.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace shellmatch
