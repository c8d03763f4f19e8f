#include "apps/cohorts/report/cohort_description.h"

#include "base/options.h"
#include "matching/report/json_page.h"

#include <algorithm>
#include <iterator>

namespace shellmatch {

namespace {

Json distance_json(const OneSidedDistance& d) { return {{"mean", d.mean}, {"p95", d.p95}, {"max", d.max}}; }

Json subject_json(const SubjectResult& subject) {
  Json row = {{"id", subject.id},           {"group", subject.group},       {"status", subject.status},
              {"message", subject.message}, {"outcome", subject.outcome},   {"diagonal", subject.diagonal},
              {"folder", subject.folder},   {"has_page", subject.has_page}, {"in_model", subject.in_model},
              {"bent", subject.bent}};
  row["reasons"] = Json::array();
  for (const VerdictReason& reason : subject.reasons)
    row["reasons"].push_back({{"what", reason.what}, {"advice", reason.advice}});
  if (subject.distance) {
    row["distance"] = {{"atlas_to_subject", distance_json(subject.distance->deformed_to_template)},
                       {"subject_to_atlas", distance_json(subject.distance->template_to_deformed)}};
    if (subject.distance->uncovered) row["distance"]["uncovered"] = *subject.distance->uncovered;
  }
  return row;
}

template <int Dim>
Json subjects_json(const CohortResult<Dim>& result, const CohortFrame& frame) {
  Json rows = Json::array();
  for (const std::size_t subject : frame.order) {
    Json row = subject_json(result.subjects[subject]);
    const auto column = std::ranges::find(result.rows, subject);
    if (column != result.rows.end()) row["column"] = std::distance(result.rows.begin(), column);
    if (const std::string& picture = frame.thumbnails.pictures[subject]; !picture.empty())
      row["thumbnail"] = base64(picture);
    rows.push_back(std::move(row));
  }
  return rows;
}

Json list_of(const Eigen::VectorXd& values) { return std::vector<double>(values.begin(), values.end()); }

// Where the corrected p is below 0.05.
double significant_share(const GroupDifference& difference, const Eigen::VectorXd& weights) {
  double share = 0;
  for (Eigen::Index v = 0; v < std::min(weights.size(), difference.p_corrected.size()); ++v)
    if (difference.p_corrected[v] < 0.05) share += weights[v];
  return share;
}

}  // namespace

template <int Dim>
std::string cohort_json(const CohortResult<Dim>& result, const CohortFrame& frame,
                        const std::vector<PackedArray>& arrays) {
  Json page = {{"title", result.title}, {"unit", result.unit}, {"dimension", Dim}, {"shape", frame.shape}};
  page["procrustes"] = enum_name(result.procrustes);
  page["subjects"] = subjects_json(result, frame);
  page["thumbnails"] = {{"scale_end", frame.thumbnails.scale_end}, {"left_out", frame.thumbnails.n_left_out}};
  if (result.model)
    page["model"] = {{"modes", frame.n_modes},
                     {"variances", list_of(result.model->variances)},
                     {"total_variance", result.model->total_variance}};
  if (const auto& c = result.curves)
    page["curves"] = {{"compactness", c->compactness},
                      {"generalisation", c->generalisation},
                      {"generalisation_error", c->generalisation_error},
                      {"specificity", c->specificity},
                      {"specificity_error", c->specificity_error}};
  if (const auto& d = result.difference) {
    page["difference"] = {{"group_a", result.group_a},
                          {"group_b", result.group_b},
                          {"n_a", d->n_a},
                          {"n_b", d->n_b},
                          {"permutations", d->n_permutations},
                          {"all_permutations", d->all_permutations},
                          {"distance", d->distance},
                          {"global_p", d->global_p}};
    if (result.model) page["difference"]["significant_share"] = significant_share(*d, result.model->weights);
  }
  page["rounds"] = Json::array();
  for (const AtlasRound& round : result.rounds)
    page["rounds"].push_back(
        {{"round", round.round}, {"subjects", round.n_subjects}, {"change", round.change}, {"spread", round.spread}});
  add_page_members(page, arrays, frame.view);
  return element_text(page);
}

SHELLMATCH_2D_3D(cohort_json);

}  // namespace shellmatch
