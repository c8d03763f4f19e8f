// GeoJSON (RFC 7946): polygons of features. QuPath writes pixels into it, with y down the rows.

#include "base/error.h"
#include "base/printable.h"
#include "base/text.h"
#include "geometry/outline/drawing.h"

#include <nlohmann/json.hpp>

#include <map>
#include <utility>

namespace shellmatch {

namespace {

using Json = nlohmann::json;

class GeoJsonReader {
 public:
  GeoJsonReader(const std::string& path, std::string_view bytes) : path_(path) {
    try {
      read(Json::parse(bytes));
    } catch (const Json::exception& error) {
      throw_input_error("{}: no JSON ({}); the file is damaged or was cut off", path, printable(error.what(), 200));
    }
  }

  Drawing finish() && {
    drawing_.is_downward = is_of_qupath_;
    const auto note = [&](std::size_t n, std::string_view one, std::string_view several, std::string_view what) {
      if (n > 0) drawing_.notes.push_back(counted(n, one, several) + std::string(what));
    };
    note(n_others_, "geometry", "geometries", " without area left out: points and lines");
    note(n_nuclei_, "nucleus", "nuclei", " of cells left out: the cells' own borders are taken");
    note(n_empty_, "object", "objects", " without geometry left out");
    if (is_of_qupath_) drawing_.notes.push_back("GeoJSON of QuPath (objectType): coordinates are pixels");
    else
      drawing_.notes.push_back(
          "GeoJSON without QuPath's objectType: y points up, coordinates as they stand; degrees are no lengths: "
          "project them");
    return std::move(drawing_);
  }

 private:
  static const Json* member(const Json& object, const char* name) {
    if (!object.is_object()) return nullptr;
    const auto found = object.find(name);
    return found == object.end() || found->is_null() ? nullptr : &*found;
  }
  static std::string text_of(const Json& object, const char* name) {
    const Json* value = member(object, name);
    if (value && value->is_string()) return value->get<std::string>();
    return value && value->is_number() ? value->dump() : "";
  }
  std::string where() const { return n_features_ == 0 ? path_ : fmt::format("{}, feature {}", path_, n_features_); }
  const Json& list_in(const Json& object, const char* name, std::string_view type) const {
    const Json* list = member(object, name);
    if (!list || !list->is_array())
      throw_input_error("{}: a {} has no list '{}'; export it again", where(), printable(type, 30), name);
    return *list;
  }

  // A document, which may be a list of features in older versions of QuPath.
  void read(const Json& json) {
    if (json.is_array()) {
      for (const Json& feature : json) read_feature(feature);
      return;
    }
    const std::string type = text_of(json, "type");
    if (type == "FeatureCollection") {
      for (const Json& feature : list_in(json, "features", type)) read_feature(feature);
    } else if (type == "Feature") {
      read_feature(json);
    } else {
      drawing_.areas.emplace_back();
      read_geometry(json, 0);
      finish_area();
    }
  }

  void read_feature(const Json& feature) {
    ++n_features_;
    if (text_of(feature, "type") != "Feature") throw_input_error("{}: is no Feature; export it again", where());
    drawing_.areas.emplace_back();
    const Json* properties = member(feature, "properties");
    std::vector<std::string>& area_names = drawing_.areas.back().names;
    // QuPath before 0.3 gave all objects of a kind one id.
    const std::string id = text_of(feature, "id");
    const bool is_kind = id.starts_with("Path") && id.ends_with("Object");
    if (properties) {
      if (std::string name = text_of(*properties, "name"); !name.empty()) area_names.push_back(std::move(name));
      if (const Json* group = member(*properties, "classification")) put_in_group(text_of(*group, "name"));
    }
    if (!id.empty() && !is_kind) area_names.push_back(id);
    is_of_qupath_ = is_of_qupath_ || is_kind ||
                    (properties && (member(*properties, "objectType") || member(*properties, "object_type")));
    n_nuclei_ += member(feature, "nucleusGeometry") != nullptr;
    if (const Json* geometry = member(feature, "geometry")) read_geometry(*geometry, 0);
    else ++n_empty_;
    finish_area();
  }

  void finish_area() {
    if (drawing_.areas.back().paths.empty()) drawing_.areas.pop_back();
  }

  void put_in_group(std::string name) {
    if (name.empty()) return;
    const auto [found, is_new] = groups_.emplace(name, drawing_.groups.size());
    if (is_new) drawing_.groups.push_back({{std::move(name)}, no_group});
    drawing_.areas.back().group = found->second;
  }

  void read_geometry(const Json& geometry, int depth) {
    const std::string type = text_of(geometry, "type");
    if (type == "Polygon") {
      read_polygon(list_in(geometry, "coordinates", type));
    } else if (type == "MultiPolygon") {
      for (const Json& polygon : list_in(geometry, "coordinates", type)) read_polygon(polygon);
    } else if (type == "GeometryCollection") {
      if (depth > deepest_group)
        throw_input_error("{}: collections are nested more than {} deep", where(), deepest_group);
      for (const Json& part : list_in(geometry, "geometries", type)) read_geometry(part, depth + 1);
    } else if (type == "Point" || type == "MultiPoint" || type == "LineString" || type == "MultiLineString") {
      ++n_others_;
    } else {
      throw_input_error(
          "{}: {}; expected a FeatureCollection, Feature, Polygon or MultiPolygon of GeoJSON", where(),
          type.empty() ? "an object without 'type'" : fmt::format("the type '{}' is unknown", printable(type, 30)));
    }
  }

  void read_polygon(const Json& rings) {
    if (!rings.is_array()) throw_input_error("{}: a polygon is no list of rings; export it again", where());
    for (const Json& ring : rings) {
      if (!ring.is_array()) throw_input_error("{}: a ring is no list of positions; export it again", where());
      std::vector<Vec<2>> points;
      points.reserve(ring.size());
      for (const Json& position : ring) {
        if (!position.is_array() || position.size() < 2 || !position[0].is_number() || !position[1].is_number())
          throw_input_error("{}: position {} of a ring is no list of two numbers", where(), points.size() + 1);
        points.emplace_back(position[0].get<double>(), position[1].get<double>());
      }
      if (!points.empty()) drawing_.areas.back().paths.push_back(path_through(points, true));
    }
  }

  const std::string& path_;
  Drawing drawing_;
  std::map<std::string, std::size_t> groups_;
  std::size_t n_features_ = 0, n_others_ = 0, n_nuclei_ = 0, n_empty_ = 0;
  bool is_of_qupath_ = false;
};

}  // namespace

Drawing read_geojson(const std::string& path, std::string_view bytes) { return GeoJsonReader(path, bytes).finish(); }

}  // namespace shellmatch
