// What `--xml` prints obeys the rules of 3D Slicer's ModuleDescriptionParser, and the program understands what Slicer
// calls it with.

#include "tests/apps/cli_harness.h"
#include "tests/matching/output/temporary_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <memory>
#include <regex>
#include <set>
#include <sstream>

namespace shellmatch {
namespace {

using testing::TemporaryFolder;

struct Element {
  std::string tag, attributes, text;
  std::vector<Element> children;

  const Element* child(const std::string& name) const {
    const auto at = std::ranges::find(children, name, &Element::tag);
    return at == children.end() ? nullptr : &*at;
  }
  std::string text_of(const std::string& name) const { return child(name) ? child(name)->text : ""; }
};

// One element and what is in it; fails where a tag is not closed in order.
Element parse(const std::string& xml, std::size_t& at) {
  Element element;
  static const std::regex opening("<([a-z-]+)([^<>]*)>");
  std::smatch found;
  const std::string rest = xml.substr(at);
  if (!std::regex_search(rest, found, opening, std::regex_constants::match_continuous)) {
    ADD_FAILURE() << "no tag at: " << rest.substr(0, 60);
    at = xml.size();
    return element;
  }
  element.tag = found[1];
  element.attributes = found[2];
  at += static_cast<std::size_t>(found.length());
  const std::string closing = "</" + element.tag + ">";
  while (at < xml.size() && xml.compare(at, closing.size(), closing) != 0) {
    if (xml[at] == '<') element.children.push_back(parse(xml, at));
    else element.text.push_back(xml[at++]);
  }
  EXPECT_LT(at, xml.size()) << closing << " is missing";
  at += closing.size();
  return element;
}

Element module_of(const std::string& command) {
  const ProgramResult result = run_program({command, "--xml"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  std::size_t at = result.out.find("?>\n") + 3;
  EXPECT_EQ(result.out.find("<?xml version=\"1.0\""), 0u);
  Element root = parse(result.out, at);
  EXPECT_EQ(result.out.substr(at), "\n");
  return root;
}

std::vector<Element> parameters_of(const Element& root) {
  static const std::set<std::string> own = {"label", "description"};
  std::vector<Element> parameters;
  for (const Element& group : root.children)
    if (group.tag == "parameters")
      for (const Element& parameter : group.children)
        if (!own.contains(parameter.tag)) parameters.push_back(parameter);
  return parameters;
}

class SlicerModule : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Commands, SlicerModule, ::testing::Values("match", "apply"));

TEST_P(SlicerModule, ObeysTheRulesOfTheParser) {
  const Element root = module_of(GetParam());
  EXPECT_EQ(root.tag, "executable");
  // The schema's order.
  const std::vector<std::string> head = {"category",          "title",   "description", "version",
                                         "documentation-url", "license", "contributor", "parameters"};
  ASSERT_GE(root.children.size(), head.size());
  for (std::size_t k = 0; k < root.children.size(); ++k)
    EXPECT_EQ(root.children[k].tag, head[std::min(k, head.size() - 1)]);
  static const std::regex variable("[A-Za-z_][A-Za-z0-9_]*");
  static const std::map<std::string, std::regex> attributes = {
      {"integer", std::regex("")},
      {"boolean", std::regex("")},
      {"string", std::regex("( multiple=\"true\")?")},
      {"string-enumeration", std::regex("")},
      {"directory", std::regex("")},
      {"file", std::regex(" fileExtensions=\"[a-z.,]+\"")},
      {"geometry", std::regex(" fileExtensions=\"[a-z.,]+\"")}};
  static const std::set<std::string> inner = {"name",    "index",   "longflag", "label",      "description",
                                              "channel", "default", "element",  "constraints"};
  std::set<std::string> names;
  int index = 0;
  for (const Element& p : parameters_of(root)) {
    SCOPED_TRACE(p.tag + " " + p.text_of("name"));
    ASSERT_TRUE(attributes.contains(p.tag));
    EXPECT_TRUE(std::regex_match(p.attributes, attributes.at(p.tag))) << p.attributes;
    for (const Element& e : p.children) EXPECT_TRUE(inner.contains(e.tag)) << e.tag;
    EXPECT_TRUE(std::regex_match(p.text_of("name"), variable));
    EXPECT_TRUE(names.insert(p.text_of("name")).second);
    EXPECT_NE(p.text_of("label"), "");
    EXPECT_NE(p.text_of("description"), "");
    EXPECT_NE(p.child("index") == nullptr, p.child("longflag") == nullptr) << "either of both";
    const bool has_index = p.child("index") != nullptr,
               is_file = p.tag == "file" || p.tag == "geometry" || p.tag == "directory";
    EXPECT_EQ(p.text_of("index"), has_index ? std::to_string(index++) : "");
    EXPECT_TRUE(has_index || std::regex_match(p.text_of("longflag"), variable));
    EXPECT_TRUE(!is_file || p.text_of("channel") == "input" || p.text_of("channel") == "output");
    const auto is_default = [&](const Element& e) { return e.tag == "element" && e.text == p.text_of("default"); };
    EXPECT_TRUE(p.tag != "string-enumeration" || std::ranges::any_of(p.children, is_default));
  }
  EXPECT_GE(index, 2);
  EXPECT_GT(names.size(), 8u);
}

// As Slicer does it: every flag with its default, files by their flags, and last what has an index.
std::vector<std::string> called(const std::string& command, const std::map<std::string, std::string>& given) {
  std::vector<std::string> words = {command}, last;
  for (const Element& p : parameters_of(module_of(command))) {
    const std::string name = p.text_of("name"), value = given.contains(name) ? given.at(name) : p.text_of("default");
    if (p.child("index")) last.push_back(value);
    else if (p.tag == "boolean") {
      if (value == "true") words.push_back("--" + p.text_of("longflag"));
    } else if (p.attributes.find("multiple") != std::string::npos) {
      std::istringstream parts(value);
      for (std::string part; std::getline(parts, part, ',');)
        words.insert(words.end(), {"--" + p.text_of("longflag"), part});
    } else if (!value.empty()) words.insert(words.end(), {"--" + p.text_of("longflag"), value});
  }
  words.insert(words.end(), last.begin(), last.end());
  return words;
}

TEST(SlicerModules, AreCalledAsTheyDescribeThemselves) {
  const TemporaryFolder tmp;
  for (const char* shape : {"ellipsoid/long", "sphere"})
    ASSERT_EQ(run_program({"generate", shape, "-o", tmp / (std::string(shape) == "sphere" ? "b.ply" : "a.ply"),
                           "--edge-length", "0.05"})
                  .exit_code,
              0);
  testing::put(tmp / "a.csv", "name,x,y,z\ntop,0.5,0.5,0.8\n");
  ProgramResult result = run_program(called("match", {{"reference", tmp / "a.ply"},
                                                      {"template", tmp / "b.ply"},
                                                      {"output", tmp / "out"},
                                                      {"levels", "3:4"},
                                                      {"align", "none"},
                                                      {"set", "pictures=none,vertex_table=true"},
                                                      {"quiet", "true"},
                                                      {"max_seconds", "500"}}));
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(std::filesystem::exists(tmp / "out/deformed.ply"));
  EXPECT_EQ(testing::contents_of(tmp / "out/deformed.csv")
                .find("x,y,z,distance_to_template,area_ratio,template_face,template_v0"),
            0u);
  EXPECT_EQ(testing::contents_of(tmp / "out/template.csv").find("x,y,z,distance_to_deformed"), 0u);
  result = run_program(called(
      "apply",
      {{"dir", tmp / "out"}, {"file", tmp / "a.csv"}, {"output", tmp / "moved.mrk.json"}, {"keep_pose", "true"}}));
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(std::filesystem::exists(tmp / "moved.mrk.json"));
  // The flags that only differ by '_' are those with '-'.
  result = run_program({"match", tmp / "a.ply", tmp / "b.ply", "-o", tmp / "x", "--template_landmarks", "none.csv"});
  EXPECT_TRUE(has(result.err, "landmarks.template_file: none.csv")) << result.err;
}

TEST(SlicerModules, AreSingleCommands) {
  const ProgramResult whole = run_program({"--xml"}), other = run_program({"inspect", "--xml"}),
                      more = run_program({"match", "a", "b", "--xml"});
  EXPECT_EQ(whole.exit_code, 2);
  EXPECT_TRUE(has(whole.err, "shellmatch match --xml or shellmatch apply --xml")) << whole.err;
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_TRUE(has(more.err, "--xml: stands alone")) << more.err;
}

}  // namespace
}  // namespace shellmatch
