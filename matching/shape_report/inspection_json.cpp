#include "matching/shape_report/inspection.h"
#include "matching/json/json_text.h"

#include <cmath>

namespace shellmatch {

std::string inspection_json(const Inspection& r) {
  Json json;
  json["source"] = r.source;
  json["dimension"] = r.dimension;
  json["frame"] = nullptr;
  if (!r.frame.empty()) json["frame"] = r.frame;
  json["original"] = {
      {"vertices", r.n_original_vertices}, {"polygons", r.n_original_polygons}, {"attributes", r.attributes}};
  json["vertices"] = r.n_vertices;
  json["facets"] = r.n_facets;
  json["components"] = r.n_components;
  json["genus"] = r.genus;
  json["buried"] = {{"vertices", r.n_buried_vertices}, {"share", r.buried_share}, {"depth", r.burial_depth}};
  json["measure"] = r.measure;
  json["enclosed"] = r.enclosed;
  json["box"] = {{"min", r.box_min}, {"max", r.box_max}};
  json["mean_edge"] = r.mean_edge;
  json["curvature_radius"] = nullptr;
  if (std::isfinite(r.curvature_radius)) json["curvature_radius"] = r.curvature_radius;
  json["scale_to_domain"] = r.scale;
  json["level_of_curvature"] = r.level_of_curvature;
  json["level_of_edges"] = r.level_of_edges;
  json["notes"] = r.notes;
  // File names may hold arbitrary bytes, which JSON does not allow.
  return json_text(json);
}

}  // namespace shellmatch
