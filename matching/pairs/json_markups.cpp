// 3D Slicer's markups as JSON: lists of control points, each list with its frame.

#include "base/error.h"
#include "base/printable.h"
#include "matching/json/json_text.h"
#include "matching/pairs/point_formats.h"
#include "matching/pairs/slicer_points.h"

#include <sstream>

namespace shellmatch {

namespace {

[[noreturn]] void no_markups(const std::string& path, std::string_view why) {
  throw_input_error("{}: damaged, or no markups of 3D Slicer ({}); save the points from Slicer as .mrk.json or .fcsv",
                    path, printable(why));
}

// Old files have numbers, as .fcsv has.
Space markups_space(const Json& markup, const std::string& path) {
  const auto at = markup.find("coordinateSystem");
  if (at == markup.end()) return Space::lps;  // Slicer's default for this format
  if (*at == "LPS" || *at == "1" || *at == 1) return Space::lps;
  if (*at == "RAS" || *at == "0" || *at == 0) return Space::ras;
  throw_input_error("{}: the coordinate system is {}; expected \"LPS\" or \"RAS\"", path,
                    printable(at->dump(-1, ' ', true), 60));
}

bool is_placed(const Json& point) {
  const auto status = point.find("positionStatus");
  return status == point.end() || *status == "defined";
}

std::string text_of(const Json& point, const char* key) {
  const auto at = point.find(key);
  return at != point.end() && at->is_string() ? at->get<std::string>() : "";
}

/// Calls visit(point, place, space) for each control point of the document, which may be constant.
template <class Document, class Visit>
void for_each_control_point(const std::string& path, Document& document, const Visit& visit) {
  if (!document.is_object() || !document.contains("markups") || !document.at("markups").is_array())
    no_markups(path, "there is no list 'markups'");
  std::size_t n = 0;
  for (auto& markup : document.at("markups")) {
    if (!markup.is_object()) no_markups(path, "an entry of 'markups' is no object");
    const Space space = markups_space(markup, path);
    if (!markup.contains("controlPoints")) continue;
    if (!markup.at("controlPoints").is_array()) no_markups(path, "'controlPoints' is no list");
    for (auto& point : markup.at("controlPoints")) {
      const std::string place = fmt::format("{}, control point {}", path, ++n);
      if (!point.is_object()) throw_input_error("{}: is no object", place);
      visit(point, place, space);
    }
  }
}

Json parsed(const std::string& path, const std::string& text) {
  try {
    std::istringstream in(text);
    return parse_json(in);
  } catch (const Json::exception& error) {
    no_markups(path, error.what());
  }
}

}  // namespace

std::vector<SlicerPoint> parse_markups(const std::string& path, const std::string& text) {
  const Json document = parsed(path, text);
  std::vector<SlicerPoint> points;
  for_each_control_point(path, document, [&](const Json& json, const std::string& place, Space space) {
    SlicerPoint point{text_of(json, "label"), Vec<3>::Zero(), space, is_placed(json), place};
    if (point.has_position) {
      const auto position = json.find("position");
      const bool is_list = position != json.end() && position->is_array() && position->size() == 3;
      for (std::size_t k = 0; k < 3; ++k) {
        if (!is_list || !(*position)[k].is_number())
          throw_input_error("{}: its position is no list of three numbers", place);
        point.position[static_cast<int>(k)] = (*position)[k].get<double>();
      }
      if (!point.position.allFinite()) throw_input_error("{}: its position is not finite", place);
    }
    points.push_back(std::move(point));
  });
  return points;
}

std::string slicer_points_json(const SlicerPoints& file) {
  Json json;
  json["source"] = file.path;
  json["points"] = Json::array();
  for (const SlicerPoint& p : file.points) {
    Json point;
    point["label"] = p.name;
    point["frame"] = space_name(p.space);
    point["position"] = nullptr;
    if (p.has_position) point["position"] = {p.position.x(), p.position.y(), p.position.z()};
    json["points"].push_back(std::move(point));
  }
  return json_text(json);
}

std::string markups_text(const PointSet<3>& set, Space space) {
  // The axes of a point are those of LPS, whatever the frame of the positions.
  const double turn = space == Space::lps ? -1 : 1;
  Json points = Json::array();
  for (std::size_t i = 0; i < set.points.size(); ++i) {
    Json point;
    point["id"] = fmt::format("{}", i + 1);
    point["label"] = set.names[i];
    point["description"] = "";
    point["associatedNodeID"] = "";
    const Vec<3> x = set.points[i].value_or(Vec<3>::Zero());
    point["position"] = {x.x(), x.y(), x.z()};
    point["orientation"] = {turn, 0.0, 0.0, 0.0, turn, 0.0, 0.0, 0.0, 1.0};
    point["selected"] = true;
    point["locked"] = false;
    point["visibility"] = true;
    point["positionStatus"] = set.points[i] ? "defined" : "missing";
    points.push_back(std::move(point));
  }
  Json markup;
  markup["type"] = "Fiducial";
  markup["coordinateSystem"] = space_name(space);
  markup["locked"] = false;
  markup["labelFormat"] = "%N-%d";
  markup["controlPoints"] = std::move(points);
  Json document;
  document["@schema"] =
      "https://raw.githubusercontent.com/slicer/slicer/master/Modules/Loadable/Markups/Resources/Schema/"
      "markups-schema-v1.0.3.json#";
  document["markups"] = Json::array({std::move(markup)});
  return json_text(document);
}

std::string markups_with_positions(const SlicerPoints& file, const std::vector<Vec<3>>& positions) {
  Json document = parsed(file.path, file.text);
  std::size_t i = 0;
  for_each_control_point(file.path, document, [&](Json& point, const std::string&, Space) {
    const Vec<3>& x = positions[i++];
    if (is_placed(point)) point["position"] = {x.x(), x.y(), x.z()};
  });
  return document.dump(4) + "\n";
}

}  // namespace shellmatch
