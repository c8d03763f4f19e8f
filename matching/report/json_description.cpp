#include "matching/report/description.h"

#include "matching/experiment/option_text.h"
#include "matching/json/json_members.h"
#include "matching/output/summary.h"
#include "matching/report/json_page.h"

#include <sstream>

namespace shellmatch {

namespace {

std::string any_value_text(const OptionNode& section, const OptionNode& option) {
  return option.level_overrides != nullptr ? level_overrides_text(section, *option.level_overrides)
                                           : value_text(option);
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

}  // namespace

std::string report_json(const MatchSummary& summary, const ExperimentOptions& options, const ReportFrame& frame,
                        const std::vector<PackedArray>& arrays) {
  std::istringstream figures(summary_json(summary));
  Json report = {{"summary", parse_json(figures)}};
  report["options"] = options_json(options);
  report["levels"] = frame.levels;
  report["terms"] = frame.term_names;
  report["grid"] = {{"finest_level", frame.grid_level},
                    {"backward", frame.is_backward},
                    {"side", frame.domain_side},
                    {"domain", frame.domain}};
  if (!frame.picture.empty()) report["picture"] = frame.picture;
  add_page_members(report, arrays, frame.view);
  return element_text(report);
}

}  // namespace shellmatch
