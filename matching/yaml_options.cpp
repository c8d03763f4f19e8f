#include "matching/yaml_options.h"

#include "base/error.h"
#include "matching/generated_source.h"
#include "matching/option_text.h"
#include "matching/yaml_document.h"

#include <array>
#include <filesystem>
#include <optional>

namespace shellmatch {

namespace {

void apply(const OptionNode& root, const Override& change) {
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
  option->set(parse_value(*option, change.value, fmt::format("{}: {}", change.origin, option->path)));
}

// The options that name files.
std::array<std::string*, 3> paths_of(InputOptions& input) {
  return {&input.reference, &input.template_file, &input.correspondence};
}

std::string beside(const std::string& file, const std::string& shape) {
  if (shape.empty() || is_generated_source(shape)) return shape;
  return (std::filesystem::path(file).parent_path() / shape).lexically_normal().string();
}

// A demand between options that is not met: the option to blame and why.
struct Conflict {
  std::string path, text;
};

std::optional<Conflict> find_conflict(const ExperimentOptions& options) {
  const CascadeOptions& cascade = options.cascade;
  const EnergyOptions& energy = options.energy;
  if (cascade.max_level < cascade.min_level)
    return Conflict{"cascade.max_level", fmt::format("{} is below cascade.min_level = {}; expected at least that",
                                                     cascade.max_level, cascade.min_level)};
  if (energy.match_weight == 0)
    return Conflict{"energy.match_weight", "0 leaves nothing that moves the reference; expected a number > 0"};
  const bool compares = energy.membrane != MembraneModel::thin_shell || energy.bending != BendingModel::thin_shell;
  if (compares && options.solver.name == "newton")
    return Conflict{"solver.name", fmt::format("newton has no second derivative for energy.membrane = {}, energy.bending "
                                               "= {}; expected a first-order method, as lbfgs",
                                               enum_name(energy.membrane), enum_name(energy.bending))};
  try {
    make_minimizer(options.solver);
  } catch (const InputError& error) {
    const std::string text = error.what(), prefix = "solver.name: ";
    return Conflict{"solver.name", text.starts_with(prefix) ? text.substr(prefix.size()) : text};
  }
  return std::nullopt;
}

// Defaults, then the document, then the overrides.
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
    options.input.reference = beside(path, options.input.reference);
    options.input.correspondence = beside(path, options.input.correspondence);
    options.input.template_file = beside(path, options.input.template_file);
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

ExperimentOptions read_experiment(const std::string& path, const std::vector<Override>& overrides) {
  YamlDocument document = YamlDocument::from_file(path);
  return resolve(&document, path, overrides);
}

ExperimentOptions make_experiment(const std::vector<Override>& overrides) { return resolve(nullptr, "", overrides); }

void apply_override(ExperimentOptions& options, const std::string& assignment) {
  const Override change = parse_override(assignment);
  if (change.key == "profile")
    throw_input_error("{}: the profile decides on the other defaults; choose it before they are set", change.origin);
  apply(option_tree(options), change);
}

void check_experiment(const ExperimentOptions& options) {
  if (const std::optional<Conflict> conflict = find_conflict(options))
    throw_input_error("{}: {}", conflict->path, conflict->text);
}

ExperimentOptions with_absolute_paths(ExperimentOptions options) {
  for (std::string* source : paths_of(options.input))
    if (!source->empty() && !is_generated_source(*source))
      *source = std::filesystem::absolute(*source).lexically_normal().string();
  return options;
}

}  // namespace shellmatch
