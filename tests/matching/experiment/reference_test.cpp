// Every option is documented, and the documentation is itself an experiment.

#include "geometry/generate/generate_shape.h"
#include "matching/experiment/option_text.h"
#include "matching/experiment/yaml_options.h"
#include "tests/support/folders.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

namespace shellmatch {
namespace {

template <class Action>
void for_each_option(const OptionNode& section, const Action& action) {
  for (const OptionNode& option : section.children) {
    action(option);
    for_each_option(option, action);
  }
}

class EveryProfile : public testing::TestWithParam<Profile> {
 protected:
  ExperimentOptions options_ = profile_defaults(GetParam());
  OptionNode root_ = option_tree(options_);
};

TEST_P(EveryProfile, EveryOptionHasAMeaning) {
  for_each_option(root_, [](const OptionNode& option) {
    EXPECT_FALSE(option.info.meaning.empty()) << option.path;
    EXPECT_EQ(option.info.meaning.find('\n'), std::string_view::npos) << option.path;
  });
}

TEST_P(EveryProfile, NamesAreSnakeCaseAndDifferWithinASection) {
  std::set<std::string> paths;
  for_each_option(root_, [&](const OptionNode& option) {
    EXPECT_TRUE(paths.insert(option.path).second) << option.path;
    EXPECT_TRUE(std::all_of(option.name.begin(), option.name.end(), [](unsigned char c) {
      return std::islower(c) || std::isdigit(c) || c == '_';
    })) << option.path;
  });
}

TEST_P(EveryProfile, DefaultsLieInTheirRanges) {
  for_each_option(root_, [](const OptionNode& option) {
    if (option.kind != OptionKind::integer && option.kind != OptionKind::real) return;
    for (const OptionScalar& value : option.get()) {
      const double number = option.kind == OptionKind::integer ? std::get<int>(value) : std::get<double>(value);
      EXPECT_TRUE(in_range(number, option.info)) << option.path << " = " << number;
    }
  });
}

TEST_P(EveryProfile, DefaultsSatisfyTheDemandsBetweenOptions) {
  EXPECT_EQ(options_.profile, GetParam());
  EXPECT_NO_THROW(check_experiment(options_));
}

TEST_P(EveryProfile, ReferenceNamesEveryOption) {
  std::ostringstream yaml, table;
  print_reference(yaml, GetParam(), ReferenceFormat::yaml);
  print_reference(table, GetParam(), ReferenceFormat::markdown);
  for_each_option(root_, [&](const OptionNode& option) {
    EXPECT_NE(yaml.str().find(option.info.meaning), std::string::npos) << option.path;
    if (option.kind != OptionKind::section) {
      EXPECT_NE(table.str().find("| `" + option.path + "` |"), std::string::npos) << option.path;
    }
  });
}

TEST_P(EveryProfile, ReferenceIsAnExperimentWithTheDefaults) {
  const std::string name = fmt::format("shellmatch_reference_{}.yaml", enum_name(GetParam()));
  const std::string path = (std::filesystem::path(testing::TempDir()) / name).string();
  {
    std::ofstream file(path);
    print_reference(file, GetParam(), ReferenceFormat::yaml);
  }
  EXPECT_EQ(to_yaml(read_experiment(path)), to_yaml(options_));
  std::filesystem::remove(path);
}

TEST_P(EveryProfile, TableRowsHaveAllTheirCells) {
  std::ostringstream table;
  print_reference(table, GetParam(), ReferenceFormat::markdown);
  std::istringstream lines(table.str());
  std::size_t n_rows = 0;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with('|')) continue;
    int bars = 0;
    for (std::size_t i = 0; i < line.size(); ++i) bars += line[i] == '|' && (i == 0 || line[i - 1] != '\\');
    EXPECT_EQ(bars, 5) << line;
    ++n_rows;
  }
  EXPECT_GT(n_rows, 80U);
}

TEST(ShippedExperiments, AreValidAndTheirShapesExist) {
  std::vector<std::pair<std::string, int>> kinds;
  for (const GeneratorInfo& info : generator_catalogue())
    for (const GeneratorVariant& variant : info.variants)
      kinds.emplace_back(fmt::format("generate:{}/{}", info.name, variant.name), info.dimension);
  const auto dimension = [&](const std::string& source) {
    if (!source.starts_with("generate:")) return 0;
    for (const auto& [name, n] : kinds)
      if (name == source) return n;
    ADD_FAILURE() << source << " is no built-in shape";
    return 0;
  };
  int n = 0;
  for (const auto& entry : std::filesystem::directory_iterator(test::source_folder() / "configs")) {
    if (entry.path().extension() != ".yaml") continue;
    SCOPED_TRACE(entry.path());
    const ExperimentOptions options = read_experiment(entry.path().string());
    EXPECT_EQ(dimension(options.input.reference), dimension(options.input.template_file));
    ++n;
  }
  EXPECT_GE(n, 6);
}

INSTANTIATE_TEST_SUITE_P(Profiles, EveryProfile, testing::Values(Profile::standard, Profile::paper),
                         [](const auto& test) { return test.param == Profile::paper ? "paper" : "standard"; });

}  // namespace
}  // namespace shellmatch
