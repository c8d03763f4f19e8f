#include "base/error.h"
#include "apps/cohorts/cohort.h"
#include "apps/cohorts/subjects/subject_table.h"
#include "geometry/mesh_text/read_text.h"
#include "matching/experiment/generated_source.h"
#include "matching/experiment/option_text.h"
#include "matching/input/shape_source.h"
#include "apps/studies/description/option_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>

namespace shellmatch {

namespace {

constexpr int known_version = 1;

std::string absolute(const std::string& path) {
  return path.empty() ? path : std::filesystem::absolute(path).lexically_normal().string();
}

// Of hundreds of subjects nobody looks at pages and pictures of all.
std::vector<Override> defaults_of_subjects() {
  return {{"pictures", "none", "a cohort's default"}, {"report", "false", "a cohort's default"}};
}

// Options that the cohort sets by itself.
void check_experiment_options(const Cohort& cohort) {
  const ExperimentOptions& o = cohort.experiment;
  const auto refuse = [&](const char* option, const char* instead) {
    throw_input_error("{}: set.{}: is another one for each subject; use {}", cohort.name, option, instead);
  };
  if (!o.input.reference.empty()) refuse("input.reference", "atlas.shape");
  if (!o.input.template_file.empty()) refuse("input.template", "shapes, or table");
  if (!o.input.correspondence.empty()) refuse("input.correspondence", "landmarks");
  if (!o.landmarks.file.empty()) refuse("landmarks.file", "atlas.landmarks");
  if (!o.landmarks.template_file.empty()) refuse("landmarks.template_file", "the column landmarks of a table");
  if (!o.start.images.empty())
    throw_input_error("{}: set.start.images: are those of the first subjects; leave it out", cohort.name);
  if (!o.start.map.empty())
    throw_input_error(
        "{}: set.start.map: is the map of one subject alone, and the rounds of a mean begin with those of the round "
        "before; leave it out",
        cohort.name);
}

void check_levels(const Cohort& cohort) {
  const CascadeOptions& c = cohort.experiment.cascade;
  const int level = cohort.round_level();
  if (level < c.min_level || level > c.max_level)
    throw_input_error(
        "{}: atlas.max_level: is {}, which is not from set.cascade.min_level ({}) to set.cascade.max_level "
        "({})",
        cohort.name, level, c.min_level, c.max_level);
}

// Paths of a file are relative to it.
void resolve_paths(CohortOptions& options, const OptionFile& file) {
  if (!options.table.empty()) options.table = absolute(file.path_of(options.table));
  for (std::string& shape : options.shapes) shape = file.source_of(shape);
  if (!options.atlas.landmarks.empty()) options.atlas.landmarks = absolute(file.path_of(options.atlas.landmarks));
}

// The atlas names a subject, a built-in shape or a file.
void resolve_atlas(Cohort& cohort, const OptionFile* file, bool is_relative_to_file) {
  AtlasOptions& atlas = cohort.options.atlas;
  if (atlas.shape.empty()) {
    if (atlas.kind == AtlasKind::given)
      throw_input_error("{}: atlas.shape: is missing, which atlas.kind given needs; name a file or the id of a subject",
                        cohort.name);
    atlas.shape = cohort.subjects.front().id;
  }
  const bool is_subject = std::ranges::any_of(cohort.subjects, [&](const Subject& s) { return s.id == atlas.shape; });
  if (is_subject) return;
  if (is_generated_source(atlas.shape)) return check_generated_source(atlas.shape);
  const std::string given = atlas.shape;
  atlas.shape = file != nullptr && is_relative_to_file ? absolute(file->source_of(atlas.shape)) : absolute(atlas.shape);
  std::error_code error;
  if (std::filesystem::exists(files_of_shape(atlas.shape).front(), error)) return;
  std::vector<std::string> ids;
  for (const Subject& subject : cohort.subjects) ids.push_back(subject.id);
  const std::string near = nearest_word(given, ids);
  throw_input_error("{}: atlas.shape: {}: no such file, and no subject has this id{}", cohort.name, given,
                    near.empty() ? "" : fmt::format("; did you mean {}?", near));
}

void read_subjects(Cohort& cohort, const CohortWords& words) {
  CohortOptions& options = cohort.options;
  if (!words.table.empty()) options.table = absolute(words.table);
  if (!words.shapes.empty()) options.shapes = words.shapes;
  if (!options.table.empty() && !options.shapes.empty())
    throw_input_error("{}: table and shapes exclude each other; leave one of them out", cohort.name);
  if (options.table.empty() && options.shapes.empty())
    throw_input_error(
        "{}: no subject is named, so that there is nothing to match; expected shapes: [FILES or patterns], "
        "or table: FILE.csv",
        cohort.name);
  cohort.subjects =
      options.table.empty() ? subjects_of(options.shapes, cohort.name) : read_subject_table(options.table);
  check_files(cohort.subjects, options.table.empty() ? cohort.name : options.table);
}

}  // namespace

Cohort read_cohort(const std::string& path, const CohortWords& words) {
  Cohort cohort;
  cohort.name = path.empty() ? "cohort" : path;
  const OptionNode root = option_tree(cohort.options);
  std::optional<OptionFile> file;
  std::vector<Override> changes;
  if (!path.empty()) {
    file.emplace(path);
    file->check_version(known_version, "cohort", "docs/cohorts.md");
    file->fill(root, root, file->document());
    file->require_version(known_version);
    resolve_paths(cohort.options, *file);
    if (const YamlValue* set = file->find("set")) file->flatten(*set, "set", "", changes);
  }
  bool atlas_of_file = true;
  for (const Override& change : words.overrides) {
    const OptionNode* option = find_option(root, change.key);
    if (option == nullptr || option->kind == OptionKind::section || change.key == "version") {
      changes.push_back(change);
      continue;
    }
    option->set(parse_value(*option, change.value, fmt::format("{}: {}", change.origin, change.key)));
    // Paths of the command line are relative to the folder in which it is given.
    if (change.key == "atlas.shape") atlas_of_file = false;
    if (change.key == "atlas.landmarks") cohort.options.atlas.landmarks = absolute(cohort.options.atlas.landmarks);
    if (change.key == "table") cohort.options.table = absolute(cohort.options.table);
  }
  if (!words.atlas.empty()) {
    cohort.options.atlas.shape = words.atlas;
    atlas_of_file = false;
  }
  std::vector<Override> all = defaults_of_subjects();
  all.insert(all.end(), changes.begin(), changes.end());
  cohort.experiment = make_experiment(all);
  check_experiment_options(cohort);
  check_levels(cohort);
  read_subjects(cohort, words);
  resolve_atlas(cohort, file ? &*file : nullptr, atlas_of_file);
  if (const auto& groups = cohort.options.statistics.groups;
      !groups.empty() && (groups.size() != 2 || groups[0] == groups[1]))
    throw_input_error("{}: statistics.groups: expected the names of two groups, as [female, male]", cohort.name);
  for (const std::string& group : cohort.options.statistics.groups)
    if (std::ranges::none_of(cohort.subjects, [&](const Subject& s) { return s.group == group; }))
      throw_input_error("{}: statistics.groups: no subject is of the group '{}'", cohort.name, group);
  return cohort;
}

std::string to_yaml(const Cohort& cohort) {
  CohortOptions options = cohort.options;
  // Patterns may stand for other files next time; the subjects do not change.
  if (options.table.empty()) {
    options.shapes.clear();
    for (const Subject& subject : cohort.subjects) options.shapes.push_back(subject.source);
  }
  OptionNode root = option_tree(options);
  std::erase_if(root.children, [](const OptionNode& option) { return option.name == "set"; });
  ExperimentOptions experiment = cohort.experiment, defaults = profile_defaults(experiment.profile);
  for (const Override& change : defaults_of_subjects()) apply_override(defaults, change);
  std::string set = changed_yaml_text(option_tree(experiment), option_tree(defaults), 1);
  if (experiment.profile != Profile::standard)
    set = fmt::format("  profile: {}\n", enum_name(experiment.profile)) + set;
  return yaml_text(root, false) + (set.empty() ? "" : "set:\n" + set);
}

std::string cohort_reference() {
  CohortOptions options;
  return "# Every option of a cohort's file with its default.\n" + yaml_text(option_tree(options), true);
}

}  // namespace shellmatch
