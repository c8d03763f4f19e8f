#include "base/error.h"
#include "base/printable.h"
#include "matching/experiment/option_text.h"
#include "matching/experiment/yaml_document.h"
#include "apps/studies/description/option_file.h"
#include "apps/studies/description/study.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

namespace shellmatch {

namespace {

constexpr int known_version = 1;

StudyChoice read_problem(const OptionFile& file, const std::string& name, const YamlValue& value) {
  const std::string path = "problems." + name;
  file.check_name(value, "problems", name);
  file.demand_map(value, path, "base: FILE.yaml, or set: with input.reference and input.template, or both");
  StudyChoice problem{name, "", {}};
  for (const auto& [key, part] : value.entries) {
    if (key == "base") {
      if (part.kind != YamlValue::Kind::scalar || part.text.empty())
        throw_input_error("{}: expected the YAML file of an experiment", file.at(part, path + ".base"));
      problem.base = file.path_of(part.text);
      if (std::error_code error; !std::filesystem::exists(problem.base, error))
        throw_input_error("{}: {}: no such file", file.at(part, path + ".base"), problem.base);
    } else if (key == "set") {
      file.flatten(part, path + ".set", "", problem.changes);
    } else {
      throw_input_error("{}: unknown key {}; allowed: base, set", file.at(part, path), key);
    }
  }
  return problem;
}

std::vector<StudyChoice> read_solvers(const OptionFile& file, const YamlValue& value) {
  std::vector<StudyChoice> solvers;
  if (value.kind == YamlValue::Kind::list) {
    for (const YamlValue& item : value.items) {
      if (item.kind != YamlValue::Kind::scalar)
        throw_input_error("{}: expected names of methods in a list, or a section with name: options",
                          file.at(item, "solvers"));
      file.check_name(item, "solvers", item.text);
      solvers.push_back({item.text, "", {file.change(item, "solvers", "solver.name")}});
    }
    return solvers;
  }
  file.demand_map(value, "solvers", "a list of methods, or a section with name: options below `solver`");
  for (const auto& [name, part] : value.entries) {
    file.check_name(part, "solvers", name);
    StudyChoice solver{name, "", {}};
    const std::string path = "solvers." + name;
    // Without the key `name`, the name of the entry is that of the method.
    const bool has_method =
        std::any_of(part.entries.begin(), part.entries.end(), [](const auto& e) { return e.first == "name"; });
    if (!has_method) solver.changes.push_back({"solver.name", name, file.at(part, path)});
    if (part.kind != YamlValue::Kind::nothing) file.flatten(part, path, "solver", solver.changes);
    solvers.push_back(std::move(solver));
  }
  return solvers;
}

}  // namespace

Study read_study(const std::string& path, std::vector<Override> overrides) {
  OptionFile file(path);
  Study study;
  study.file = path;
  const OptionNode root = option_tree(study.options);
  file.check_version(known_version, "study", "docs/studies.md");
  file.fill(root, root, file.document());
  // On the command line, keys of the study are given beside options of an experiment.
  for (Override& change : overrides) {
    const OptionNode* option = find_option(root, change.key);
    if (option != nullptr && option->kind != OptionKind::section && change.key != "version")
      option->set(parse_value(*option, change.value, fmt::format("{}: {}", change.origin, change.key)));
    else study.overrides.push_back(std::move(change));
  }
  if (!study.options.folder.empty()) file.set_folder(study.options.folder);
  file.require_version(known_version);

  if (const YamlValue* set = file.find("set")) file.flatten(*set, "set", "", study.common);
  const YamlValue* problems = file.find("problems");
  if (problems == nullptr || problems->kind == YamlValue::Kind::nothing || problems->entries.empty())
    throw_input_error(
        "{}: no problem is named, so that there is nothing to run; expected problems: "
        "{{NAME: {{base: FILE.yaml}}}}",
        problems == nullptr ? path : file.at(*problems, "problems"));
  for (const auto& [name, value] : problems->entries) study.problems.push_back(read_problem(file, name, value));
  if (const YamlValue* solvers = file.find("solvers")) study.solvers = read_solvers(file, *solvers);
  if (study.solvers.empty())
    throw_input_error(
        "{}: solvers: none is named, so that there is nothing to run; expected solvers: [{}] or some of them", path,
        fmt::join(minimizer_names(), ", "));
  if (const YamlValue* metrics = file.find("metrics")) study.metrics = file.list(*metrics, "metrics", "solver.metric");
  if (const YamlValue* parameters = file.find("parameters")) {
    file.demand_map(*parameters, "parameters", "a section with option: [values]");
    for (const auto& [key, value] : parameters->entries)
      study.parameters.push_back({key, file.list(value, "parameters." + key, key)});
  }
  return study;
}

}  // namespace shellmatch
