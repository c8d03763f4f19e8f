#include "apps/cohorts/execution/stage_tasks.h"

#include "base/error.h"
#include "apps/cohorts/execution/stage_result.h"
#include "apps/cohorts/subjects/mirrored.h"
#include "matching/alignment/align_shapes.h"
#include "matching/map_file/deformation_file.h"
#include "matching/output/summary.h"

#include <algorithm>
#include <filesystem>
#include <numeric>
#include <utility>

namespace shellmatch {

namespace {

// The result of an earlier round with which a matching may begin; empty where there is none, or one that
// leads astray.
std::string usable_result(const std::string& runs, const std::string& id) {
  const std::string output = runs + "/" + id + "/output";
  if (runs.empty() || !std::filesystem::exists(output + "/" + deformation_file_name)) return "";
  try {
    return is_near(read_summary(output + "/summary.json")) ? output : "";
  } catch (const InputError&) {
    return "";
  }
}

// Two of them would do for a mean; of more, one may be strange.
constexpr std::size_t n_first = 3;

}  // namespace

std::vector<std::size_t> first_subjects(const Cohort& cohort) {
  const ExperimentOptions& o = cohort.experiment;
  if (cohort.options.atlas.kind != AtlasKind::given || align_mode(o) != AlignMode::automatic) return {};
  std::vector<std::size_t> order(cohort.subjects.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t k) { return cohort.subjects[k].id; });
  if (order.size() <= n_first) return {};
  order.resize(n_first);
  return order;
}

std::vector<std::string> StageTasks::images_of(const std::vector<std::size_t>& subjects,
                                               const std::string& runs) const {
  std::vector<std::string> images;
  for (const std::size_t k : subjects)
    if (std::string result = usable_result(runs, cohort_.subjects[k].id); !result.empty())
      images.push_back(std::move(result));
  return images;
}

std::string StageTasks::source_of(const Subject& subject) const {
  return subject.reflect ? mirrored_shape(subject, cohort_.experiment.input, folder_) : subject.source;
}

std::string StageTasks::landmarks_of(const Subject& subject) const {
  if (subject.landmarks.empty() || !subject.reflect) return subject.landmarks;
  return mirrored_landmarks(subject, cohort_.experiment.input, folder_);
}

RunTask StageTasks::task(const Stage& stage, const AtlasFiles& atlas, const Subject& subject) {
  ExperimentOptions o = cohort_.experiment;
  o.input.reference = atlas.shape;
  o.input.template_file = source_of(subject);
  if (cohort_.options.landmarks == LandmarkUse::match && !atlas.landmarks.empty() && !subject.landmarks.empty()) {
    o.landmarks.file = atlas.landmarks;
    o.landmarks.template_file = landmarks_of(subject);
    o.landmarks.unpaired = UnpairedLandmarks::are_left_out;
  }
  // The mean has moved little: its matching begins where that of the round before has ended.
  o.start.map = usable_result(atlas.runs, subject.id);
  if (!o.start.map.empty() && !stage.is_last()) o.start.level = cohort_.round_level();
  if (std::ranges::none_of(first_, [&](std::size_t k) { return cohort_.subjects[k].id == subject.id; }))
    o.start.images = atlas.images;
  // Many matchings side by side use a machine better than many threads of one.
  o.threads = std::max(1, o.threads);
  o.resume = {.enabled = false};
  if (!stage.is_last()) {
    o.cascade.max_level = cohort_.round_level();
    o.pictures = Pictures::none;
    o.report = false;
  }
  std::string inputs;
  try {
    inputs = inputs_.of(o, subject.id);
  } catch (const InputError& error) {
    inputs = error.what();
  }
  ExperimentOptions on_any_machine = o;
  on_any_machine.threads = 1;
  return {subject.id, to_yaml(o), fingerprint_of(on_any_machine, inputs)};
}

std::vector<RunTask> StageTasks::of(const Stage& stage, const AtlasFiles& atlas,
                                    const std::vector<std::size_t>& subjects) {
  std::vector<RunTask> tasks;
  for (const std::size_t k : subjects) tasks.push_back(task(stage, atlas, cohort_.subjects[k]));
  return tasks;
}

}  // namespace shellmatch
