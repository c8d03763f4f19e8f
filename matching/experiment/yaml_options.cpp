#include "matching/experiment/yaml_options.h"

#include "base/error.h"
#include "energies/terms/term_names.h"
#include "matching/experiment/generated_source.h"
#include "matching/experiment/level_solver.h"
#include "matching/experiment/option_text.h"
#include "matching/experiment/yaml_document.h"

#include <cmath>
#include <filesystem>
#include <optional>
#include <vector>

namespace shellmatch {

namespace {

// Returns true where the key leads into overrides by level, as "solver.levels.3-5.name", and sets them.
bool apply_to_levels(const OptionNode& root, const Override& change) {
  for (std::size_t dot = change.key.find('.'); dot != std::string::npos; dot = change.key.find('.', dot + 1)) {
    const std::string path = change.key.substr(0, dot);
    const OptionNode* levels = find_option(root, path);
    if (levels == nullptr || levels->kind != OptionKind::level_overrides) continue;
    const std::size_t end = change.key.find('.', dot + 1);
    const std::string where = fmt::format("{}: {}", change.origin, path);
    LevelOverrides::Entry& entry = levels->level_overrides->at(change.key.substr(dot + 1, end - dot - 1), where);
    const OptionNode& section = *find_option(root, path.substr(0, path.rfind('.')));
    const std::string rest = end == std::string::npos ? "" : change.key.substr(end + 1);
    const OptionNode* option = overridable_option(section, rest, where);
    if (option->kind == OptionKind::section)
      throw_input_error("{}: {} is a section; set its options one by one", where, rest);
    entry.set(rest, parse_value(*option, change.value, fmt::format("{}: {}", change.origin, change.key)));
    return true;
  }
  return false;
}

void apply(const OptionNode& root, const Override& change) {
  if (apply_to_levels(root, change)) return;
  const std::size_t dot = change.key.rfind('.');
  const OptionNode* option = find_option(root, change.key);
  if (option == nullptr) {
    const OptionNode* section = dot == std::string::npos ? nullptr : find_option(root, change.key.substr(0, dot));
    const bool known = section != nullptr && section->kind == OptionKind::section;
    throw_input_error("{}: {}", change.origin,
                      unknown_key_text(root, known ? *section : root, known ? change.key.substr(dot + 1) : change.key));
  }
  if (option->kind == OptionKind::section)
    throw_input_error("{}: {} is a section; set its options one by one, as {}.{}=...", change.origin, option->path,
                      option->path, option->children.front().name);
  if (option->kind == OptionKind::level_overrides)
    throw_input_error("{}: set its options one by one, as {}.3-5.name=lbfgs", change.origin, option->path);
  option->set(parse_value(*option, change.value, fmt::format("{}: {}", change.origin, option->path)));
}

// The options that are names of files.
std::vector<std::string*> paths_of(ExperimentOptions& options) {
  std::vector<std::string*> paths{&options.input.reference,         &options.input.template_file,
                                  &options.input.correspondence,    &options.landmarks.file,
                                  &options.landmarks.template_file, &options.start.map};
  for (std::string& folder : options.start.images) paths.push_back(&folder);
  return paths;
}

std::string beside(const std::string& file, const std::string& shape) {
  if (shape.empty() || is_generated_source(shape)) return shape;
  return (std::filesystem::path(file).parent_path() / shape).lexically_normal().string();
}

// A violated condition between options: the option to blame and the reason.
struct Conflict {
  std::string path, text;
};

// The conflict in the solver options of `section`, if there is one.
std::optional<Conflict> solver_conflict(const SolverOptions& solver, const std::string& section) {
  try {
    make_minimizer(solver);
  } catch (const InputError& error) {
    const std::string text = error.what();
    for (const std::string key : {"name", "fallback"})
      if (const std::string prefix = "solver." + key + ": "; text.starts_with(prefix))
        return Conflict{section + "." + key, text.substr(prefix.size())};
    return Conflict{section == "solver" ? "solver.name" : section, text};
  }
  return std::nullopt;
}

std::optional<Conflict> find_conflict(const ExperimentOptions& options) {
  const CascadeOptions& cascade = options.cascade;
  if (cascade.max_level < cascade.min_level)
    return Conflict{"cascade.max_level", fmt::format("{} is below cascade.min_level = {}; expected at least that",
                                                     cascade.max_level, cascade.min_level)};
  if (options.start.level != 0 && options.start.map.empty())
    return Conflict{"start.level", "is the level that a map of an earlier run begins at, and start.map names none"};
  if (const int level = options.start.level; level != 0 && (level < cascade.min_level || level > cascade.max_level))
    return Conflict{"start.level", fmt::format("{} is not from cascade.min_level = {} to cascade.max_level = {}", level,
                                               cascade.min_level, cascade.max_level)};
  if (options.energy.terms.factor("match"_term) == 0 && options.landmarks.file.empty())
    return Conflict{"energy.match_weight",
                    "0 leaves nothing that moves the reference; expected a number > 0, or landmarks"};
  if (auto conflict = solver_conflict(options.solver, "solver")) return conflict;
  for (const LevelOverrides::Entry& e : options.solver.levels.entries)
    if (auto conflict = solver_conflict(solver_at_level(options.solver, e.first), "solver.levels." + e.key()))
      return conflict;
  return std::nullopt;
}

// Checks the ranges of values that a program has set; those of documents and overrides are checked on reading.
void check_ranges(const OptionNode& section) {
  for (const OptionNode& option : section.children) {
    if (option.kind == OptionKind::section) check_ranges(option);
    if (option.kind != OptionKind::integer && option.kind != OptionKind::real) continue;
    for (const OptionScalar& value : option.get()) {
      const double number = option.kind == OptionKind::real ? std::get<double>(value) : std::get<int>(value);
      if (!std::isfinite(number) || !in_range(number, option.info))
        throw_input_error("{}: {} is out of range; expected {}", option.path, scalar_text(value, option.kind),
                          allowed_text(option));
    }
  }
}

// Applies the defaults, then the document, then the overrides.
ExperimentOptions resolve(YamlDocument* document, const std::string& path, const std::vector<Override>& overrides) {
  ExperimentOptions options;
  {
    const OptionNode root = option_tree(options);
    if (document != nullptr) document->fill_one(root, "profile");
    for (const Override& change : overrides)
      if (change.key == "profile") apply(root, change);
  }
  const Profile profile = options.profile;
  options = profile_defaults(profile);
  const OptionNode root = option_tree(options);
  if (document != nullptr) {
    document->fill(root);
    for (std::string* source : paths_of(options)) *source = beside(path, *source);
  }
  for (const Override& change : overrides) apply(root, change);
  options.profile = profile;

  if (const std::optional<Conflict> conflict = find_conflict(options)) {
    std::string place = document != nullptr ? document->place(conflict->path) : conflict->path;
    for (const Override& change : overrides)
      if (change.key == conflict->path) place = fmt::format("{}: {}", change.origin, conflict->path);
    throw_input_error("{}: {}", place, conflict->text);
  }
  return options;
}

}  // namespace

Override parse_override(const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos || equals == 0)
    throw_input_error("--set {}: expected key.sub=value, as in cascade.nu=0.01", assignment);
  return {assignment.substr(0, equals), assignment.substr(equals + 1), "--set " + assignment};
}

Override beside_file(Override change, const std::string& file) {
  ExperimentOptions options;
  const OptionNode root = option_tree(options);
  const OptionNode* option = find_option(root, change.key);
  if (option == nullptr || option->kind != OptionKind::text) return change;
  // The option holds paths if setting it changes some of them.
  apply(root, change);
  const std::vector<OptionScalar> given = option->get();
  for (std::string* path : paths_of(options)) *path = beside(file, *path);
  const std::vector<OptionScalar> found = option->get();
  if (found == given) return change;
  std::vector<std::string> texts;
  for (const OptionScalar& path : found) {
    texts.push_back(std::get<std::string>(path));
    if (!option->is_list) continue;
    std::string quoted = "'";  // as in YAML: quotes are doubled
    for (const char c : texts.back()) quoted += c == '\'' ? std::string("''") : std::string(1, c);
    texts.back() = quoted + "'";
  }
  change.value = option->is_list ? fmt::format("[{}]", fmt::join(texts, ", ")) : texts.front();
  return change;
}

ExperimentOptions read_experiment(const std::string& path, const std::vector<Override>& overrides) {
  YamlDocument document = YamlDocument::from_file(path);
  return resolve(&document, path, overrides);
}

ExperimentOptions make_experiment(const std::vector<Override>& overrides) { return resolve(nullptr, "", overrides); }

void apply_override(ExperimentOptions& options, const std::string& assignment) {
  apply_override(options, parse_override(assignment));
}

void apply_override(ExperimentOptions& options, const Override& change) {
  if (change.key == "profile")
    throw_input_error("{}: the profile decides on the other defaults; choose it before they are set", change.origin);
  apply(option_tree(options), change);
}

void check_experiment(const ExperimentOptions& options) {
  ExperimentOptions copy = options;
  check_ranges(option_tree(copy));
  if (const std::optional<Conflict> conflict = find_conflict(options))
    throw_input_error("{}: {}", conflict->path, conflict->text);
}

ExperimentOptions with_absolute_paths(ExperimentOptions options) {
  for (std::string* source : paths_of(options))
    if (!source->empty() && !is_generated_source(*source))
      *source = std::filesystem::absolute(*source).lexically_normal().string();
  return options;
}

}  // namespace shellmatch
