#include "apps/command_line/slicer_module.h"

#include "matching/experiment/option_tree.h"
#include "matching/experiment/options.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>

namespace shellmatch {

namespace {

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '&') out += "&amp;";
    else if (c == '<') out += "&lt;";
    else if (c == '>') out += "&gt;";
    else out.push_back(c);
  }
  return out;
}

std::string element(std::string_view tag, std::string_view text) {
  return fmt::format("      <{}>{}</{}>\n", tag, escaped(text), tag);
}

// Options of the command line that stand for one of an experiment.
constexpr std::pair<std::string_view, std::string_view> keys[] = {
    {"placement", "input.placement"}, {"align", "align.mode"}, {"profile", "profile"}, {"threads", "threads"}};

const OptionNode* find(const OptionNode& node, std::string_view path) {
  if (node.path == path) return &node;
  for (const OptionNode& child : node.children)
    if (const OptionNode* found = find(child, path)) return found;
  return nullptr;
}

/// What the experiment says of the option; null of one that is the command line's own.
const OptionNode* node_of(const OptionNode& options, std::string_view name) {
  for (const auto& [own, key] : keys)
    if (own == name) return find(options, key);
  return nullptr;
}

/// A parameter: its tag with attributes, and what is particular to it.
struct Parameter {
  std::string tag, attributes = {}, more = {};
};

constexpr std::string_view meshes = ".vtp,.vtk,.ply,.obj,.stl,.off";
constexpr std::string_view volumes = ".nii.gz,.nii,.nrrd,.mha";

Parameter file_parameter(std::string_view extensions, const char* channel, const char* tag = "file") {
  return {tag, fmt::format(" fileExtensions=\"{}\"", extensions), element("channel", channel)};
}

Parameter positional(std::string_view name) {
  if (name == "DIR") return {"directory", "", element("channel", "input")};
  if (name == "FILE") return file_parameter(fmt::format("{},.mrk.json,.fcsv,.csv,{}", meshes, volumes), "input");
  return file_parameter(meshes, "input", "geometry");
}

// By what the help says its value is.
Parameter named(const CLI::Option& option, const std::string& name, const OptionNode* node) {
  const std::string type = option.get_type_name();
  if (option.get_items_expected_max() == 0) return {"boolean", "", element("default", "false")};
  if (type == "DIR") return {"directory", "", element("channel", "output")};
  if (type == "FILE" && name == "output")
    return file_parameter(fmt::format("{},.mrk.json,.fcsv,.csv,.tps,{}", meshes, volumes), "output");
  if (type == "FILE") return file_parameter(".mrk.json,.fcsv,.csv", "input");
  if (type == "VOLUME") return file_parameter(volumes, name == "like" ? "input" : "output");
  if (node != nullptr && node->kind == OptionKind::choice) {
    Parameter parameter{"string-enumeration", "", element("default", std::get<std::string>(node->get().front()))};
    for (const std::string& choice : node->choices) parameter.more += element("element", choice);
    return parameter;
  }
  if (node != nullptr && node->kind == OptionKind::integer)
    return {"integer", "",
            element("default", fmt::format("{}", std::get<int>(node->get().front()))) +
                fmt::format("      <constraints>\n        <minimum>{}</minimum>\n        <maximum>{}</maximum>\n       "
                            " <step>1</step>\n      </constraints>\n",
                            node->info.min, node->info.max)};
  return {"string", option.get_items_expected_max() > 1 ? " multiple=\"true\"" : "", ""};
}

std::string label_of(std::string name) {
  std::ranges::replace(name, '_', ' ');
  name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
  return name;
}

std::string parameter_text(const Parameter& p, const std::string& name, const std::string& place,
                           const std::string& description) {
  return fmt::format("    <{}{}>\n{}{}{}{}{}    </{}>\n", p.tag, p.attributes, element("name", name), place,
                     element("label", label_of(name)), element("description", description), p.more, p.tag);
}

}  // namespace

std::string slicer_module_xml(const CLI::App& command) {
  ExperimentOptions defaults;
  const OptionNode tree = option_tree(defaults);
  std::string main, further;
  int index = 0;
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_positional()) {
      const Parameter p = positional(option->get_name());
      std::string name = option->get_name();
      std::ranges::transform(name, name.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
      main += parameter_text(p, name, element("index", std::to_string(index++)), option->get_description());
      continue;
    }
    std::string name = option->get_lnames().front();
    if (name == "help" || name == "xml") continue;
    const Parameter p = named(*option, name, node_of(tree, name));
    std::ranges::replace(name, '-', '_');
    std::string description = option->get_description();
    // The words between which a text chooses, and its form, stand in the help as its type.
    if (p.tag == "string") description += fmt::format(" ({})", option->get_type_name());
    (p.tag == "file" || p.tag == "directory" ? main : further) +=
        parameter_text(p, name, element("longflag", name), description);
  }
  const std::string title = "Shellmatch " + command.get_name();
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<executable>\n  <category>Surface Models.Registration</category>\n  "
      "<title>{}</title>\n"
      "  <description>{}</description>\n  <version>" SHELLMATCH_VERSION
      "</version>\n  <documentation-url></documentation-url>\n"
      "  <license></license>\n  <contributor></contributor>\n"
      "  <parameters>\n    <label>Shapes and files</label>\n    <description>What is read and "
      "written</description>\n{}  </parameters>\n"
      "  <parameters advanced=\"true\">\n    <label>Options</label>\n    <description>As on the command "
      "line</description>\n{}  </parameters>\n</executable>\n",
      escaped(title), escaped(command.get_description()), main, further);
}

}  // namespace shellmatch
