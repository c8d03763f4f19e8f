#pragma once
/// \file
/// A cohort as its file or the command line describes it: one atlas, many subjects, and what is computed of them.

#include "apps/cohorts/subjects/subject.h"
#include "apps/studies/description/option_file.h"
#include "apps/studies/execution/run_task.h"
#include "base/options.h"
#include "geometry/statistics/procrustes.h"
#include "matching/experiment/level_overrides.h"
#include "matching/experiment/options.h"
#include "matching/experiment/yaml_options.h"

#include <string>
#include <vector>

namespace shellmatch {

/// Where the shape comes from that is deformed onto every subject.
enum class AtlasKind { given, medoid, mean };
template <>
struct EnumNames<AtlasKind> {
  static constexpr std::pair<AtlasKind, std::string_view> names[] = {
      {AtlasKind::given, "given"}, {AtlasKind::medoid, "medoid"}, {AtlasKind::mean, "mean"}};
};

struct AtlasOptions {
  AtlasKind kind = AtlasKind::mean;
  std::string shape, landmarks;
  int max_level = 0;
  int rounds = 5;
  double tolerance = 0.25;
  static void describe(auto& self, auto& visit) {
    visit("kind", self.kind,
          {.meaning = "given: the shape `atlas.shape` is deformed onto every subject; mean: it is the start of an "
                      "iteration, in which the mean of all deformed atlases becomes the next atlas until it converges; "
                      "medoid: the subject that is nearest to the mean after one round is the atlas"});
    visit("shape", self.shape,
          {.meaning = "file of the atlas, or the id of a subject; empty: the first subject; relative to this file"});
    visit("landmarks", self.landmarks,
          {.meaning = "file of points of `atlas.shape` (docs/landmarks.md), which are carried to every subject; "
                      "relative to this file"});
    visit("max_level", self.max_level,
          {.unit = "level",
           .min = 0,
           .max = finest_level,
           .meaning = "finest level of the rounds; 0: set.cascade.max_level. On coarser levels thin parts are not "
                      "reached, and the mean loses some of them in every round"});
    visit("rounds", self.rounds,
          {.unit = "rounds", .min = 1, .max = 100, .meaning = "most rounds of kind mean before the last one"});
    visit(
        "tolerance", self.tolerance,
        {.unit = "standard error of the mean",
         .min = 0,
         .meaning =
             "the mean has converged where its surface has moved by no more than this share of its standard error, the "
             "spread of the subjects over the root of their number; all root mean squares after Procrustes analysis"});
  }
};

/// What landmarks of subjects are for.
enum class LandmarkUse { match, compare };
template <>
struct EnumNames<LandmarkUse> {
  static constexpr std::pair<LandmarkUse, std::string_view> names[] = {{LandmarkUse::match, "match"},
                                                                       {LandmarkUse::compare, "compare"}};
};

/// Which subjects make the mean and the statistics, by their verdicts.
enum class Included { matched, look_here, all };
template <>
struct EnumNames<Included> {
  static constexpr std::pair<Included, std::string_view> names[] = {
      {Included::matched, "matched"}, {Included::look_here, "look-here"}, {Included::all, "all"}};
};

struct StatisticsOptions {
  ProcrustesKind procrustes = ProcrustesKind::rigid;
  Included include = Included::look_here;
  int model_subjects = 1000;
  int modes = 0;
  int mode_meshes = 5;
  int samples = 1000;
  std::vector<std::string> groups;
  int permutations = 1000;
  int seed = 1;
  static void describe(auto& self, auto& visit) {
    visit("procrustes", self.procrustes,
          {.meaning = "what is taken out of the differences of subjects: none; rigid: position and direction; "
                      "similarity: size, too"});
    visit("include", self.include,
          {.meaning = "worst verdict (docs/verdict.md) with which a subject is part of mean and statistics: matched, "
                      "look-here, or all that have a result"});
    visit(
        "model_subjects", self.model_subjects,
        {.unit = "subjects",
         .min = 2,
         .max = 10000,
         .meaning = "most subjects that modes and curves are computed from, as their cost grows with the third power; "
                    "of a larger cohort those at equal steps through the table, and the others have scores only"});
    visit("modes", self.modes,
          {.unit = "modes", .min = 0, .max = 100000, .meaning = "most modes that are kept; 0: all"});
    visit("mode_meshes", self.mode_meshes,
          {.unit = "modes",
           .min = 0,
           .max = 1000,
           .meaning = "number of modes of which meshes and animations are written"});
    visit("samples", self.samples,
          {.unit = "shapes", .min = 10, .max = 1000000, .meaning = "random shapes for specificity"});
    visit(
        "groups", self.groups,
        {.meaning =
             "names of two groups that are compared, second minus first; empty: those of the table where it has two"});
    visit("permutations", self.permutations,
          {.unit = "permutations", .min = 20, .max = 1000000, .meaning = "of the tests between groups"});
    visit("seed", self.seed, {.min = 0, .meaning = "of random shapes and permutations"});
  }
};

/// The options of a cohort's file.
struct CohortOptions {
  int version = 1;
  std::string title, table;
  std::vector<std::string> shapes;
  AtlasOptions atlas;
  LandmarkUse landmarks = LandmarkUse::match;
  StatisticsOptions statistics;
  RunLimits limits{.seconds = 0, .grace_seconds = 5, .memory_mb = 0};
  FreeSection set;
  static void describe(auto& self, auto& visit) {
    visit("version", self.version, {.min = 1, .meaning = "of the form of this file; 1"});
    visit("title", self.title, {.meaning = "heading of the report"});
    visit("table", self.table,
          {.meaning = "CSV file with a line for each subject and the columns id, file, landmarks, group, reflect, of "
                      "which file is needed; relative to this file, its own paths to itself"});
    visit("shapes", self.shapes,
          {.meaning = "instead of a table: files of subjects, or patterns with * and ?; relative to this file"});
    visit("atlas", self.atlas,
          {.meaning = "the shape that is deformed onto every subject: the reference of all matchings"});
    visit("landmarks", self.landmarks,
          {.meaning =
               "match: landmarks of the atlas and of a subject pull at each other; compare: they are only measured"});
    visit("statistics", self.statistics, {.meaning = "mean, modes and groups (docs/statistics.md)"});
    visit("limits", self.limits, {.meaning = "what one matching may cost"});
    visit("set", self.set, {.meaning = "options of an experiment for all matchings (docs/options.md)"});
  }
};

struct Cohort {
  /// Finest level of the rounds.
  int round_level() const {
    return options.atlas.max_level == 0 ? experiment.cascade.max_level : options.atlas.max_level;
  }

  std::string name;       ///< of the file, or of the command, for messages
  CohortOptions options;  ///< paths are absolute
  std::vector<Subject> subjects;
  ExperimentOptions experiment;  ///< without shapes and landmarks
};

/// What the command line says instead of a file, or besides it.
struct CohortWords {
  std::vector<std::string> shapes;  ///< files or patterns
  std::string table, atlas;
  std::vector<Override> overrides;  ///< of the cohort's options or of the experiment's
};

/// \param file of the cohort; empty where the words are all
/// \throws InputError naming file, line and key: unknown keys, no subjects, a missing file, two subjects of one id
Cohort read_cohort(const std::string& file, const CohortWords& words);

/// The cohort as a file that can be read from anywhere.
std::string to_yaml(const Cohort& cohort);

/// Every option of a cohort's file with its default and meaning, as YAML.
std::string cohort_reference();

}  // namespace shellmatch
