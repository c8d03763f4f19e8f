#include "apps/cohorts/output/cohort_summary.h"

#include "matching/progress/process_info.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace shellmatch {

Spread spread_of(std::vector<double> values) {
  if (values.empty()) return {};
  std::ranges::sort(values);
  // The least value that is not exceeded by this share of all.
  const auto quantile = [&](double share) {
    const auto k = static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size())));
    return values[std::max<std::size_t>(k, 1) - 1];
  };
  return {values.size(), quantile(0.5), quantile(0.95), values.back()};
}

template <int Dim>
CohortSummary cohort_summary(const CohortResult<Dim>& result, const std::vector<CarriedLandmark<Dim>>& carried) {
  CohortSummary s;
  s.version = program_version();
  s.title = result.title;
  s.unit = result.unit;
  s.n_subjects = result.subjects.size();
  s.n_in_model = result.rows.size();
  s.rounds = result.rounds;
  std::vector<double> there, back, landmarks;
  for (const SubjectResult& subject : result.subjects) {
    if (subject.status != "finished") continue;
    ++s.n_finished;
    ++(subject.outcome == "matched" ? s.n_matched : subject.outcome == "look-here" ? s.n_look_here : s.n_not_matched);
    if (!subject.distance) continue;
    there.push_back(subject.distance->deformed_to_template.mean * subject.diagonal);
    back.push_back(subject.distance->template_to_deformed.mean * subject.diagonal);
  }
  for (const CarriedLandmark<Dim>& c : carried)
    if (c.known) landmarks.push_back((*c.known - c.carried).norm());
  if (!there.empty()) {
    s.deformed_to_subject = spread_of(std::move(there));
    s.subject_to_deformed = spread_of(std::move(back));
  }
  if (!landmarks.empty()) s.landmarks = spread_of(std::move(landmarks));
  if (result.model) {
    s.standard_deviation = std::sqrt(result.model->total_variance);
    double sum = 0;
    for (Eigen::Index k = 0; k < std::min<Eigen::Index>(10, result.model->variances.size()); ++k)
      s.compactness.push_back((sum += result.model->variances[k]) / result.model->total_variance);
  }
  if (const auto& d = result.difference) {
    s.group_a = result.group_a;
    s.group_b = result.group_b;
    s.group_distance = d->distance;
    s.group_p = d->global_p;
    s.differing_share =
        static_cast<double>((d->p_corrected.array() < 0.05).count()) / static_cast<double>(d->p_corrected.size());
  }
  return s;
}

std::vector<std::string> cohort_summary_lines(const CohortSummary& s) {
  std::vector<std::string> lines;
  const std::string unit = s.unit.empty() ? "" : " " + s.unit;
  lines.push_back(fmt::format(
      "{} subjects: {} matched, {} matched but look there, {} not matched, {} without a result; {} in the "
      "statistics",
      s.n_subjects, s.n_matched, s.n_look_here, s.n_not_matched, s.n_subjects - s.n_finished, s.n_in_model));
  if (s.deformed_to_subject)
    lines.push_back(fmt::format("mean distance to the subject: median {:.3g}{}, worst {:.3g}; from it: {:.3g}, {:.3g}",
                                s.deformed_to_subject->median, unit, s.deformed_to_subject->max,
                                s.subject_to_deformed->median, s.subject_to_deformed->max));
  if (s.landmarks)
    lines.push_back(fmt::format("{} landmarks: median {:.3g}{} from the known ones, 95 % within {:.3g}", s.landmarks->n,
                                s.landmarks->median, unit, s.landmarks->p95));
  if (s.standard_deviation && s.compactness.empty()) {
    lines.push_back("the subjects do not differ: there are no modes");
  } else if (s.standard_deviation) {
    std::string shares;
    for (std::size_t k = 0; k < std::min<std::size_t>(5, s.compactness.size()); ++k)
      shares += fmt::format("{}{:.0f}", k == 0 ? "" : ", ", 100 * s.compactness[k]);
    lines.push_back(fmt::format("standard deviation {:.3g}{}; the first modes hold {} % of the variance",
                                *s.standard_deviation, unit, shares));
  }
  if (s.group_a)
    lines.push_back(
        fmt::format("{} and {}: means {:.3g}{} apart (p = {:.3g}); they differ at {:.1f} % of the points (p "
                    "corrected < 0.05)",
                    *s.group_a, *s.group_b, *s.group_distance, unit, *s.group_p, 100 * *s.differing_share));
  return lines;
}

std::string without_result(const CohortSummary& summary, const std::vector<SubjectResult>& subjects) {
  const auto first =
      std::ranges::find_if(subjects, [](const SubjectResult& subject) { return subject.status != "finished"; });
  if (first == subjects.end()) return "";
  return fmt::format("{} of {} subjects have no result; the first is {}, {}{}{}",
                     summary.n_subjects - summary.n_finished, summary.n_subjects, first->id, first->status,
                     first->message.empty() ? "" : ": ", first->message);
}

SHELLMATCH_2D_3D(cohort_summary);

}  // namespace shellmatch
