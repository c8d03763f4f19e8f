#include "base/error.h"
#include "base/text.h"
#include "apps/cohorts/cohort.h"
#include "apps/cohorts/subjects/subject_table.h"
#include "matching/experiment/yaml_document.h"
#include "matching/experiment/yaml_options.h"
#include "apps/studies/description/study.h"
#include "tests/fuzz/memory_file.h"
#include "tests/fuzz/target.h"

#include <set>
#include <string>
#include <vector>

namespace shellmatch::fuzz {

namespace {

// Options of all kinds.
enum class Colour { red, green };

struct Some {
  bool flag = false;
  int number = 1;
  double value = 0.5;
  std::string text;
  std::vector<double> list;
  Colour colour = Colour::red;
  static void describe(auto& self, auto& visit) {
    visit("flag", self.flag, {.meaning = "a flag"});
    visit("number", self.number, {.min = 0, .max = 9, .meaning = "a number"});
    visit("value", self.value, {.min = 0, .meaning = "a value"});
    visit("text", self.text, {.meaning = "a text"});
    visit("list", self.list, {.meaning = "a list"});
    visit("colour", self.colour, {.meaning = "a choice"});
  }
};

struct Options {
  int version = 1;
  Some some;
  static void describe(auto& self, auto& visit) {
    visit("version", self.version, {.min = 1, .meaning = "a version"});
    visit("some", self.some, {.meaning = "a section"});
  }
};

// What follows the first separator are settings as of the command line.
std::vector<Override> overrides_of(const std::vector<std::string_view>& parts) {
  std::vector<Override> overrides;
  for (std::size_t i = 1; i < parts.size(); ++i) overrides.push_back(parse_override(std::string(parts[i])));
  return overrides;
}

}  // namespace
}  // namespace shellmatch::fuzz

template <>
struct shellmatch::EnumNames<shellmatch::fuzz::Colour> {
  static constexpr std::pair<fuzz::Colour, std::string_view> names[] = {{fuzz::Colour::red, "red"},
                                                                        {fuzz::Colour::green, "green"}};
};

namespace shellmatch::fuzz {

void read_options(std::string_view bytes) {
  const auto parts = parts_of(bytes, separator);
  Options options;
  const OptionNode root = option_tree(options);
  for (std::size_t i = 1; i < parts.size(); ++i)
    for (const OptionNode& option : root.children[1].children) {
      try {
        option.set(parse_value(option, std::string(parts[i]), "value"));
      } catch (const InputError&) {
        // Every kind of option sees the text.
      }
    }
  YamlDocument document = YamlDocument::from_text(std::string(parts[0]), "input");
  const std::string text = document.tree().flow_text();
  demand(text.size() < 100 * bytes.size() + 1000000, "a document does not grow without bound");
  document.fill_one(root, "version");
  document.fill(root);
  document.place("some.number");
  demand(options.some.number >= 0 && options.some.number <= 9 && options.some.value >= 0 && options.version >= 1,
         "options lie in their ranges");
}

void read_whole_experiment(std::string_view bytes) {
  const auto parts = parts_of(bytes, separator);
  const MemoryFile file(parts[0]);
  const ExperimentOptions options = read_experiment(file.path(), overrides_of(parts));
  check_experiment(options);
  const std::string text = to_yaml(with_absolute_paths(options));
  const MemoryFile again(text);
  demand(to_yaml(read_experiment(again.path())) == text, "an experiment that is written is read back");
}

void read_whole_study(std::string_view bytes) {
  const auto parts = parts_of(bytes, separator);
  const MemoryFile file(parts[0]);
  const Study study = read_study(file.path(), overrides_of(parts));
  demand(!study.problems.empty() && !study.solvers.empty(), "a study has problems and solvers");
  demand(study.options.repeats >= 1 && study.options.limits.seconds >= 0, "keys of a study lie in their ranges");
  for (const StudyParameter& parameter : study.parameters) demand(!parameter.values.empty(), "a parameter has values");
}

namespace {

void check_subject_list(const std::vector<Subject>& subjects) {
  demand(!subjects.empty(), "a cohort has subjects");
  std::set<std::string> ids;
  for (const Subject& subject : subjects) {
    demand(ids.insert(subject.id).second, "ids differ");
    demand(!subject.id.empty() && subject.id == safe_file_name(subject.id) && subject.id[0] != '.',
           "an id is the name of a folder");
    demand(!subject.source.empty(), "a subject has a shape");
  }
}

}  // namespace

void read_table_of_subjects(std::string_view bytes) {
  const MemoryFile file(bytes);
  const std::vector<Subject> subjects = read_subject_table(file.path());
  check_subject_list(subjects);
  for (const Subject& subject : subjects)
    demand(subject.further.size() == subjects[0].further.size(), "all lines have the columns of the head");
}

void read_whole_cohort(std::string_view bytes) {
  // Patterns of whole folders would be looked up on this machine's disk.
  if (bytes.find_first_of("*?[") != bytes.npos && bytes.find('/') != bytes.npos) return;
  auto parts = parts_of(bytes, separator);
  const MemoryFile file(parts[0]);
  CohortWords words;
  words.overrides = overrides_of(parts);
  const Cohort cohort = read_cohort(file.path(), words);
  check_subject_list(cohort.subjects);
  demand(cohort.round_level() >= cohort.experiment.cascade.min_level &&
             cohort.round_level() <= cohort.experiment.cascade.max_level,
         "the rounds' level is one of the cascade's");
  const std::string text = to_yaml(cohort);
  const MemoryFile again(text);
  demand(to_yaml(read_cohort(again.path(), {})) == text, "a cohort that is written is read back");
}

}  // namespace shellmatch::fuzz
