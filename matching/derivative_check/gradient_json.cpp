#include "matching/derivative_check/gradient_report.h"
#include "matching/json/json_text.h"

namespace shellmatch {

namespace {

Json to_json(const DirectionCheck& d) {
  Json json = {{"resolved", d.resolved}, {"steps", d.steps}, {"remainders", d.remainders},
               {"orders", d.orders},     {"slope", d.slope}, {"second_derivative", d.curvature}};
  if (d.model_curvature) json["model_second_derivative"] = *d.model_curvature;
  json["points_near_faces"] = d.n_points_near_faces;
  json["held_share"] = d.held_share;
  return json;
}

Json to_json(const WorstElement& w) {
  return {
      {"element", w.element}, {"level", w.level},       {"centre", w.centre},        {"corner", w.corner},
      {"axis", w.axis},       {"analytic", w.analytic}, {"dual_numbers", w.by_jets}, {"differences", w.by_differences}};
}

Json to_json(const TermCheck& t) {
  Json json = {{"term", t.name}, {"state", name_of(t.state)}};
  if (t.state == TermCheck::State::off) return json;
  json["value"] = t.value;
  json["gradient_norm"] = t.gradient_norm;
  json["directions"] = Json::array();
  for (const DirectionCheck& d : t.directions) json["directions"].push_back(to_json(d));
  json["functors"] = {{"value_error", t.value_error},
                      {"gradient_error", t.gradient_error},
                      {"element_error_in_tolerances", t.element_error}};
  json["differences"] = {{"error_in_tolerances", t.difference_error},
                         {"elements", t.n_elements},
                         {"compared", t.n_differenced},
                         {"left_out_near_faces", t.n_elements_near_faces},
                         {"with_kinks", t.n_elements_with_kinks}};
  json["ceres"] = {{"elements", t.ceres.n_elements},
                   {"failed", t.ceres.n_failed},
                   {"worst_relative_error", t.ceres.worst_relative_error}};
  if (t.hessian)
    json["newton_model"] = {{"asymmetry", t.hessian->asymmetry}, {"least_quotient", t.hessian->least_quotient}};
  if (t.worst) json["worst_element"] = to_json(*t.worst);
  json["faults"] = t.faults;
  json["notes"] = t.notes;
  return json;
}

}  // namespace

std::string gradient_report_json(const GradientReport& r) {
  Json json = {{"passed", r.passed()},
               {"experiment", r.source},
               {"state", r.state},
               {"dimension", r.dimension},
               {"level", r.level},
               {"nodes", r.n_nodes},
               {"free_nodes", r.n_free_nodes},
               {"nu", r.nu},
               {"volume_weight", r.volume_weight},
               {"terms", Json::array()}};
  for (const TermCheck& t : r.terms) json["terms"].push_back(to_json(t));
  // File names may hold arbitrary bytes, which JSON does not allow.
  return json_text(json);
}

}  // namespace shellmatch
