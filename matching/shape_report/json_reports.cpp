#include "matching/json/json_text.h"
#include "matching/progress/process_info.h"
#include "matching/shape_report/curvature_report.h"
#include "matching/shape_report/inspection.h"

#include <cmath>

namespace shellmatch {

namespace {

Json to_json(const ErrorQuantiles& q) { return {{"median", q.median}, {"p95", q.p95}}; }

// Numbers that are not finite become null.
Json to_json(const CurvatureErrors& e, int dimension) {
  Json json = {{"vertices", e.n_vertices}, {"k1", to_json(e.k1)}};
  if (dimension == 2) return json;
  json["k2"] = to_json(e.k2);
  json["direction_degrees"] = to_json(e.direction);
  json["directions"] = e.n_directions;
  return json;
}

}  // namespace

template <int Dim>
std::string curvature_json(const CurvatureComparison<Dim>& c, const CurvatureSubject& subject) {
  Json json = {{"version", program_version()},
               {"dimension", Dim},
               {"shape", subject.source},
               {"vertices", c.surface.vertices.size()},
               {"diagonal", c.diagonal},
               {"unit_of_errors", "1/diagonal"},
               {"mesh_fit", {{"degree", Dim == 2 ? 2 : subject.fit.degree}, {"rings", subject.fit.n_rings}}},
               {"distance", std::string(enum_name(subject.coefficients.distance))}};
  if (c.mesh_fit_to_formula) json["mesh_fit_to_formula"] = to_json(*c.mesh_fit_to_formula, Dim);
  json["levels"] = Json::array();
  for (const CurvatureLevel& l : c.levels) {
    Json level = {{"level", l.level},
                  {"side_over_diagonal", l.side},
                  {"nodes", l.n_nodes},
                  {"free_nodes", l.n_free_nodes},
                  {"distance_seconds", l.distance_seconds},
                  {"coefficient_seconds", l.coefficient_seconds},
                  {"to_mesh_fit", to_json(l.to_mesh_fit, Dim)}};
    if (l.to_formula) level["to_formula"] = to_json(*l.to_formula, Dim);
    if (l.formula_to_formula) level["formula_distance_to_formula"] = to_json(*l.formula_to_formula, Dim);
    json["levels"].push_back(level);
  }
  return json_text(json);
}

SHELLMATCH_2D_3D(curvature_json);

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
