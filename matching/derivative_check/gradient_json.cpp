#include "matching/derivative_check/gradient_report.h"
#include "matching/json/json_members.h"

namespace shellmatch {

SHELLMATCH_JSON(DirectionCheck, resolved, steps, remainders, orders, slope, (curvature, second_derivative),
                (model_curvature, model_second_derivative), (n_points_near_faces, points_near_faces), held_share)
SHELLMATCH_JSON(WorstElement, element, level, centre, corner, axis, analytic, (by_jets, dual_numbers),
                (by_differences, differences))
SHELLMATCH_JSON(HessianCheck, asymmetry, least_quotient)
SHELLMATCH_JSON(CeresProbes, (n_elements, elements), (n_failed, failed), worst_relative_error)

namespace {

Json to_json(const TermCheck& t) {
  Json json = {{"term", t.name}, {"state", name_of(t.state)}};
  if (t.state == TermCheck::State::off) return json;
  json["value"] = t.value;
  json["gradient_norm"] = t.gradient_norm;
  json["directions"] = json_of(t.directions);
  json["functors"] = {{"value_error", t.value_error},
                      {"gradient_error", t.gradient_error},
                      {"element_error_in_tolerances", t.element_error}};
  json["differences"] = {{"error_in_tolerances", t.difference_error},
                         {"elements", t.n_elements},
                         {"compared", t.n_differenced},
                         {"left_out_near_faces", t.n_elements_near_faces},
                         {"with_kinks", t.n_elements_with_kinks}};
  json["ceres"] = json_of(t.ceres);
  if (t.hessian) json["newton_model"] = json_of(*t.hessian);
  if (t.worst) json["worst_element"] = json_of(*t.worst);
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
