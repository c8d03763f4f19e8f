#include "matching/pairs/tps_specimens.h"

#include "base/printable.h"
#include "base/text.h"
#include "geometry/io/input_file.h"
#include "geometry/outline/drawing.h"
#include "matching/json/json_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace shellmatch {

namespace {

std::string name_of(const TpsSpecimen& specimen) { return specimen.id ? *specimen.id : specimen.image.value_or(""); }

// "20", or "18 to 20" where they differ.
template <class Count>
std::string range_of(const std::vector<TpsSpecimen>& specimens, const Count& count) {
  std::vector<std::size_t> counts;
  for (const TpsSpecimen& s : specimens) counts.push_back(count(s));
  const auto [least, most] = std::ranges::minmax(counts);
  return least == most ? fmt::format("{}", least) : fmt::format("{} to {}", least, most);
}

}  // namespace

std::optional<std::vector<TpsSpecimen>> listed_specimens(const std::string& source) {
  const PartName name = split_part(source);
  if (format_of(name.file) != FileFormat::tps) return {};
  std::vector<TpsSpecimen> specimens = parse_tps(name.file, InputFile(name.file).read());
  if (name.part.empty() && specimens.size() > 1) return specimens;
  const TpsSpecimen& specimen = chosen_specimen(specimens, name.file, name.part);
  return specimen.curves.empty() ? std::optional(std::vector{specimen}) : std::nullopt;
}

std::string specimens_text(const std::string& source, const std::vector<TpsSpecimen>& specimens) {
  std::vector<std::string> names;
  for (const TpsSpecimen& s : specimens)
    if (const std::string name = name_of(s); !name.empty()) names.push_back(name);
  const auto missing = [](const TpsSpecimen& s) {
    return static_cast<std::size_t>(std::ranges::count_if(s.landmarks, [](const auto& x) { return !x; }));
  };
  const auto n_scales = static_cast<std::size_t>(
      std::ranges::count_if(specimens, [](const TpsSpecimen& s) { return s.scale.has_value(); }));
  std::string text = fmt::format("{}: {} of TPS\n", printable(source, max_message_length),
                                 counted(specimens.size(), "specimen", "specimens"));
  const auto line = [&](std::string_view what, const std::string& value) {
    text += fmt::format("  {:<22}{}\n", what, value);
  };
  line("landmarks",
       fmt::format("{} of {}, of which {} without position",
                   range_of(specimens, [](const TpsSpecimen& s) { return s.landmarks.size(); }),
                   specimens.front().dimension == 2 ? "the plane" : "space", range_of(specimens, missing)));
  line("outlines and curves", range_of(specimens, [](const TpsSpecimen& s) { return s.curves.size(); }));
  line("with SCALE=", fmt::format("{}", n_scales));
  line("names", names.empty() ? "none: give each an ID=, by which one can be chosen" : some_names(names));
  return text;
}

std::string specimens_json(const std::string& source, const std::vector<TpsSpecimen>& specimens) {
  Json json;
  json["source"] = source;
  json["specimens"] = Json::array();
  for (const TpsSpecimen& s : specimens) {
    Json specimen;
    specimen["name"] = name_of(s);
    specimen["dimension"] = s.dimension;
    specimen["curves"] = s.curves.size();
    specimen["landmarks"] = Json::array();
    for (const auto& x : s.landmarks) {
      Json point;
      if (x)
        for (int k = 0; k < s.dimension; ++k) point.push_back(s.factor() * (*x)[k]);
      specimen["landmarks"].push_back(std::move(point));
    }
    json["specimens"].push_back(std::move(specimen));
  }
  return json_text(json);
}

}  // namespace shellmatch
