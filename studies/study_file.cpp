#include "base/error.h"
#include "base/printable.h"
#include "matching/experiment/option_text.h"
#include "matching/experiment/yaml_document.h"
#include "studies/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace shellmatch {

namespace {

constexpr int known_version = 1;

// Reads the parts of a study's file.
class Reader {
 public:
  explicit Reader(std::string file)
      : file_(std::move(file)), folder_(std::filesystem::path(file_).parent_path()), experiment_tree_(option_tree(experiment_)) {}

  void set_folder(const std::string& folder) {
    folder_ = folder;
    if (!folder_.is_absolute()) throw_input_error("{}: folder: {} is no absolute path, one that begins with /", file_, printable(folder));
  }

  std::string path_of(const std::string& name) const { return (folder_ / name).lexically_normal().string(); }

  std::string at(const YamlValue& value, const std::string& path) const {
    return fmt::format("{}:{}: {}", file_, value.line, path);
  }

  void demand_map(const YamlValue& value, const std::string& path, const char* expected) const {
    if (value.kind != YamlValue::Kind::map)
      throw_input_error("{}: {}; expected {}", at(value, path),
                        value.kind == YamlValue::Kind::nothing ? "is empty" : "is no section", expected);
  }

  // The options of an experiment, in nested sections or with dotted keys, as overrides in their order.
  void flatten(const YamlValue& section, const std::string& path, const std::string& prefix,
               std::vector<Override>& changes) const {
    demand_map(section, path, "options of an experiment, as cascade: {max_level: 6}");
    for (const auto& [name, value] : section.entries) {
      const std::string key = prefix.empty() ? name : prefix + "." + name;
      if (value.kind == YamlValue::Kind::map)
        flatten(value, path, key, changes);
      else
        changes.push_back(change(value, path, key));
    }
  }

  Override change(const YamlValue& value, const std::string& path, const std::string& key) const {
    const OptionNode* option = find_option(experiment_tree_, key);
    const bool to_the_letter = option != nullptr && option->kind == OptionKind::text && !option->is_list &&
                               value.kind == YamlValue::Kind::scalar;
    return beside_file({key, to_the_letter ? value.text : value.flow_text(), at(value, path)}, folder_ / "study.yaml");
  }

  std::vector<Override> list(const YamlValue& value, const std::string& path, const std::string& key) const {
    if (value.kind != YamlValue::Kind::list || value.items.empty())
      throw_input_error("{}: {}; expected a list of values of {}", at(value, path),
                        value.kind == YamlValue::Kind::list ? "is an empty list" : "is no list", key);
    std::vector<Override> values;
    for (const YamlValue& item : value.items) values.push_back(change(item, path, key));
    return values;
  }

  // Names become parts of file names and of run names, in which hyphens separate the parts.
  void check_name(const YamlValue& value, const std::string& path, const std::string& name) const {
    const auto good = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
    if (name.empty() || name.size() > 60 || !std::all_of(name.begin(), name.end(), good))
      throw_input_error("{}: the name '{}' cannot be used; expected letters, digits and '_', at most 60",
                        at(value, path), name.substr(0, 80));
  }

 private:
  std::string file_;
  std::filesystem::path folder_;  // to which paths are relative
  ExperimentOptions experiment_;
  OptionNode experiment_tree_;
};

StudyChoice read_problem(const Reader& reader, const std::string& name, const YamlValue& value) {
  const std::string path = "problems." + name;
  reader.check_name(value, "problems", name);
  reader.demand_map(value, path, "base: FILE.yaml, or set: with input.reference and input.template, or both");
  StudyChoice problem{name, "", {}};
  for (const auto& [key, part] : value.entries) {
    if (key == "base") {
      if (part.kind != YamlValue::Kind::scalar || part.text.empty())
        throw_input_error("{}: expected the YAML file of an experiment", reader.at(part, path + ".base"));
      problem.base = reader.path_of(part.text);
      if (std::error_code error; !std::filesystem::exists(problem.base, error))
        throw_input_error("{}: {}: no such file", reader.at(part, path + ".base"), problem.base);
    } else if (key == "set") {
      reader.flatten(part, path + ".set", "", problem.changes);
    } else {
      throw_input_error("{}: unknown key {}; allowed: base, set", reader.at(part, path), key);
    }
  }
  return problem;
}

std::vector<StudyChoice> read_solvers(const Reader& reader, const YamlValue& value) {
  std::vector<StudyChoice> solvers;
  if (value.kind == YamlValue::Kind::list) {
    for (const YamlValue& item : value.items) {
      if (item.kind != YamlValue::Kind::scalar)
        throw_input_error("{}: expected names of methods in a list, or a section with name: options",
                          reader.at(item, "solvers"));
      reader.check_name(item, "solvers", item.text);
      solvers.push_back({item.text, "", {reader.change(item, "solvers", "solver.name")}});
    }
    return solvers;
  }
  reader.demand_map(value, "solvers", "a list of methods, or a section with name: options below `solver`");
  for (const auto& [name, part] : value.entries) {
    reader.check_name(part, "solvers", name);
    StudyChoice solver{name, "", {}};
    const std::string path = "solvers." + name;
    // Without the key `name`, the name of the entry is that of the method.
    const bool has_method = std::any_of(part.entries.begin(), part.entries.end(),
                                        [](const auto& e) { return e.first == "name"; });
    if (!has_method) solver.changes.push_back({"solver.name", name, reader.at(part, path)});
    if (part.kind != YamlValue::Kind::nothing) reader.flatten(part, path, "solver", solver.changes);
    solvers.push_back(std::move(solver));
  }
  return solvers;
}

void fill(const Reader& reader, const OptionNode& root, const OptionNode& section, const YamlValue& values) {
  for (const auto& [key, value] : values.entries) {
    const auto option = std::find_if(section.children.begin(), section.children.end(),
                                     [&key = key](const OptionNode& child) { return child.name == key; });
    if (option == section.children.end())
      throw_input_error("{}{}", reader.at(value, ""), unknown_key_text(root, section, key));
    if (option->kind == OptionKind::section) {
      if (option->children.empty()) continue;  // a section whose keys the user chooses
      reader.demand_map(value, option->path, "a section");
      fill(reader, root, *option, value);
    } else {
      const std::string text = option->kind == OptionKind::text ? value.text : value.flow_text();
      option->set(parse_value(*option, text, reader.at(value, option->path)));
    }
  }
}

}  // namespace

Study read_study(const std::string& path, std::vector<Override> overrides) {
  const YamlValue document = YamlDocument::from_file(path).tree();
  Reader reader(path);
  Study study;
  study.file = path;

  const auto find = [&](const char* key) -> const YamlValue* {
    for (const auto& [name, value] : document.entries)
      if (name == key) return &value;
    return nullptr;
  };
  const OptionNode root = option_tree(study.options);
  // The keys of another version may have other meanings, so that the version is checked first.
  if (const YamlValue* version = find("version"))
    if (version->text != std::to_string(known_version))
      throw_input_error(
          "{}: is {}, and this program reads version {} of study files only; docs/studies.md describes it",
          reader.at(*version, "version"), version->flow_text().empty() ? "empty" : version->flow_text(),
          known_version);
  fill(reader, root, root, document);
  // On the command line, keys of the study are given beside options of an experiment.
  for (Override& change : overrides) {
    const OptionNode* option = find_option(root, change.key);
    if (option != nullptr && option->kind != OptionKind::section && change.key != "version")
      option->set(parse_value(*option, change.value, fmt::format("{}: {}", change.origin, change.key)));
    else
      study.overrides.push_back(std::move(change));
  }
  if (!study.options.folder.empty()) reader.set_folder(study.options.folder);
  if (find("version") == nullptr)
    throw_input_error("{}: version is missing; expected version: {} at the top", path, known_version);

  if (const YamlValue* set = find("set")) reader.flatten(*set, "set", "", study.common);
  const YamlValue* problems = find("problems");
  if (problems == nullptr || problems->kind == YamlValue::Kind::nothing || problems->entries.empty())
    throw_input_error(
        "{}: no problem is named, so that there is nothing to run; expected problems: "
        "{{NAME: {{base: FILE.yaml}}}}",
        problems == nullptr ? path : reader.at(*problems, "problems"));
  for (const auto& [name, value] : problems->entries)
    study.problems.push_back(read_problem(reader, name, value));
  if (const YamlValue* solvers = find("solvers")) study.solvers = read_solvers(reader, *solvers);
  if (study.solvers.empty())
    throw_input_error(
        "{}: solvers: none is named, so that there is nothing to run; expected solvers: [{}] or some of them",
        path, fmt::join(minimizer_names(), ", "));
  if (const YamlValue* metrics = find("metrics"))
    study.metrics = reader.list(*metrics, "metrics", "solver.metric");
  if (const YamlValue* parameters = find("parameters")) {
    reader.demand_map(*parameters, "parameters", "a section with option: [values]");
    for (const auto& [key, value] : parameters->entries)
      study.parameters.push_back({key, reader.list(value, "parameters." + key, key)});
  }
  return study;
}

}  // namespace shellmatch
