#include "apps/cohorts/output/cohort_tables.h"

#include "base/text.h"
#include "apps/cohorts/report/worst_first.h"
#include "geometry/mesh_text/read_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

namespace shellmatch {

namespace {

template <int Dim>
std::string coordinates_text(const Vec<Dim>& x) {
  std::string text;
  for (int k = 0; k < Dim; ++k) text += fmt::format(",{}", x[k]);
  return text;
}

constexpr std::array axis_names = {"x", "y", "z"};

template <int Dim>
std::string axes_text(const std::string& prefix) {
  std::string text;
  for (int k = 0; k < Dim; ++k) text += "," + prefix + axis_names[static_cast<std::size_t>(k)];
  return text;
}

}  // namespace

std::string subjects_csv(const Cohort& cohort, const std::vector<SubjectResult>& subjects,
                         const std::vector<std::size_t>& rows) {
  // Unit: that of the shapes; distances of a run are stated over the diagonal.
  std::string text = "id,group,status,verdict,row";
  for (const char* direction : {"deformed_to_subject", "subject_to_deformed"})
    for (const char* figure : {"mean", "p95", "max"}) text += fmt::format(",{}_{}", direction, figure);
  text += ",uncovered,diagonal,bent,reasons,message,file,reflect";
  std::vector<std::string> further;
  for (const auto& [name, value] : cohort.subjects.front().further) further.push_back(name);
  for (const std::string& name : further) text += "," + csv_field(name);
  text += "\n";
  for (const std::size_t k : worst_first(subjects)) {
    const SubjectResult& s = subjects[k];
    const auto row = std::ranges::find(rows, k);
    text += fmt::format("{},{},{},{},{}", csv_field(s.id), csv_field(s.group), s.status, s.outcome,
                        row == rows.end() ? "" : std::to_string(row - rows.begin()));
    for (int direction = 0; direction < 2; ++direction)
      for (int figure = 0; figure < 3; ++figure) {
        text += ",";
        if (!s.distance) continue;
        const OneSidedDistance& d =
            direction == 0 ? s.distance->deformed_to_template : s.distance->template_to_deformed;
        text += fmt::format("{}", (figure == 0 ? d.mean : figure == 1 ? d.p95 : d.max) * s.diagonal);
      }
    text += s.distance && s.distance->uncovered ? fmt::format(",{}", *s.distance->uncovered) : ",";
    text += s.diagonal > 0 ? fmt::format(",{}", s.diagonal) : ",";
    text += s.outcome.empty() ? "," : s.bent ? ",1" : ",0";
    std::string reasons;
    for (const VerdictReason& reason : s.reasons) reasons += (reasons.empty() ? "" : "; ") + reason.what;
    text += fmt::format(",{},{},{},{}", csv_field(reasons), csv_field(s.message), csv_field(cohort.subjects[k].source),
                        cohort.subjects[k].reflect ? 1 : 0);
    for (const auto& [name, value] : cohort.subjects[k].further) text += "," + csv_field(value);
    text += "\n";
  }
  return text;
}

std::string times_csv(const std::vector<SubjectResult>& subjects) {
  std::string text = "id,seconds\n";
  for (const SubjectResult& s : subjects) text += fmt::format("{},{:.3f}\n", csv_field(s.id), s.seconds);
  return text;
}

std::string scores_csv(const ShapeModel& model, const std::vector<SubjectResult>& subjects,
                       const std::vector<std::size_t>& rows) {
  std::string text = "id,group";
  for (Eigen::Index k = 0; k < model.variances.size(); ++k) text += fmt::format(",mode_{}", k + 1);
  text += "\n";
  for (std::size_t c = 0; c < rows.size(); ++c) {
    text += csv_field(subjects[rows[c]].id) + "," + csv_field(subjects[rows[c]].group);
    for (Eigen::Index k = 0; k < model.variances.size(); ++k)
      text += fmt::format(",{}", model.scores(static_cast<Eigen::Index>(c), k));
    text += "\n";
  }
  return text;
}

std::string modes_csv(const ShapeModel& model, const std::optional<ModelCurves>& curves) {
  std::string text =
      "modes,variance,share,compactness,generalisation,generalisation_error,specificity,specificity_error\n";
  const auto entry = [](const std::vector<double>& list, std::size_t k) {
    return k < list.size() ? fmt::format(",{}", list[k]) : std::string(",");
  };
  double sum = 0;
  for (Eigen::Index k = 0; k < model.variances.size(); ++k) {
    sum += model.variances[k];
    text += fmt::format("{},{},{},{}", k + 1, model.variances[k], model.variances[k] / model.total_variance,
                        sum / model.total_variance);
    const ModelCurves none;
    const ModelCurves& c = curves ? *curves : none;
    for (const std::vector<double>* list :
         {&c.generalisation, &c.generalisation_error, &c.specificity, &c.specificity_error})
      text += entry(*list, static_cast<std::size_t>(k));
    text += "\n";
  }
  return text;
}

template <int Dim>
std::string landmarks_csv(const std::vector<SubjectResult>& subjects, const std::vector<NamedPoint<Dim>>& landmarks,
                          const std::vector<CarriedLandmark<Dim>>& carried) {
  std::string text = "id,name" + axes_text<Dim>("") + axes_text<Dim>("known_") + ",distance\n";
  for (const CarriedLandmark<Dim>& c : carried) {
    text += csv_field(subjects[c.subject].id) + "," + csv_field(landmarks[c.landmark].name) +
            coordinates_text<Dim>(c.carried);
    if (c.known) text += coordinates_text<Dim>(*c.known) + fmt::format(",{}", (*c.known - c.carried).norm());
    else text.append(Dim + 1, ',');
    text += "\n";
  }
  return text;
}

template <int Dim>
std::vector<PointSet<Dim>> landmark_sets(const std::vector<SubjectResult>& subjects,
                                         const std::vector<NamedPoint<Dim>>& landmarks,
                                         const std::vector<CarriedLandmark<Dim>>& carried) {
  std::map<std::size_t, PointSet<Dim>> sets;
  for (const CarriedLandmark<Dim>& c : carried) {
    PointSet<Dim>& set = sets[c.subject];
    set.individual = subjects[c.subject].id;
    set.points.resize(landmarks.size());
    set.points[c.landmark] = c.carried;
  }
  std::vector<PointSet<Dim>> list;
  for (auto& [subject, set] : sets) {
    for (const NamedPoint<Dim>& landmark : landmarks) set.names.push_back(landmark.name);
    list.push_back(std::move(set));
  }
  return list;
}

template <int Dim>
std::string returned_landmarks_csv(const std::vector<SubjectResult>& subjects,
                                   const std::vector<ReturnedLandmark<Dim>>& returned) {
  std::string text = "id,name" + axes_text<Dim>("") + "\n";
  for (const ReturnedLandmark<Dim>& r : returned) {
    text += csv_field(subjects[r.subject].id) + "," + csv_field(r.name);
    if (r.returned) text += coordinates_text<Dim>(*r.returned);
    else text.append(Dim, ',');
    text += "\n";
  }
  return text;
}

SHELLMATCH_2D_3D(landmarks_csv);
SHELLMATCH_2D_3D(landmark_sets);
SHELLMATCH_2D_3D(returned_landmarks_csv);

}  // namespace shellmatch
