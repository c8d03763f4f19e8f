#include "tests/repository/mutation_rules.h"

#include <fmt/format.h>

#include <optional>
#include <set>
#include <sstream>

namespace shellmatch::repository {

namespace {

constexpr const char* list = "tests/mutations.txt";

struct Mutation {
  int line = 0;  // of its first
  std::vector<std::string> before, after;
};

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (std::size_t i = 0; i < lines.size(); ++i) text += (i > 0 ? "\n" : "") + lines[i];
  return text;
}

int occurrences(const std::string& text, const std::string& part) {
  int n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++n;
  return n;
}

// The programs' names, without the "test_" before them: shellmatch_test(name ...) and functions made from it.
std::set<std::string> test_programs(const SourceTree& tree) {
  const std::string_view command = "_test(";
  std::set<std::string> names;
  for (const auto& [file, lines] : tree.files) {
    if (!file.starts_with("tests/") || !file.ends_with("CMakeLists.txt")) continue;
    for (const std::string& line : lines)
      if (const std::size_t at = line.find(command); at != std::string::npos) {
        const std::size_t begin = at + command.size();
        names.insert(line.substr(begin, line.find_first_of(" )", begin) - begin));
      }
  }
  return names;
}

// The file's text, null if the heading is wrong.
std::optional<std::string> text_of(const SourceTree& tree, const std::string& heading, int number,
                                   const std::set<std::string>& programs, std::vector<Finding>& findings) {
  const std::size_t colon = heading.find(':');
  const std::string file = heading.substr(0, colon);
  const auto found = tree.files.find(file);
  if (found == tree.files.end()) {
    findings.push_back({list, number, fmt::format("{} does not exist", file)});
    return {};
  }
  std::istringstream words(colon == std::string::npos ? "" : heading.substr(colon + 1));
  int n_programs = 0;
  for (std::string word; words >> word; ++n_programs)
    if (const std::string name = word.substr(0, word.find('/')); !programs.contains(name))
      findings.push_back({list, number, fmt::format("there is no test program test_{}", name)});
  if (n_programs == 0) findings.push_back({list, number, "a heading is 'file: test programs'"});
  return joined(found->second);
}

void check_one(const Mutation& mutation, const std::string& text, const std::string& file,
               std::vector<Finding>& findings) {
  if (mutation.line == 0) return;
  const int n = mutation.before.empty() ? 0 : occurrences(text, joined(mutation.before));
  if (n != 1)
    findings.push_back({list, mutation.line,
                        fmt::format("the old text occurs {} times in {}: bring the entry up to date", n, file)});
  else if (mutation.before == mutation.after)
    findings.push_back({list, mutation.line, "old and new text are the same"});
}

}  // namespace

std::vector<Finding> check_mutations(const SourceTree& tree) {
  const auto lines = tree.files.find(list);
  if (lines == tree.files.end()) return {{list, 0, "does not exist"}};
  const std::set<std::string> programs = test_programs(tree);
  std::vector<Finding> findings;
  std::optional<std::string> text;
  std::string heading;
  Mutation mutation;
  const auto end_mutation = [&] {
    if (text) check_one(mutation, *text, heading.substr(0, heading.find(':')), findings);
    mutation = {};
  };
  for (std::size_t i = 0; i < lines->second.size(); ++i) {
    const std::string& line = lines->second[i];
    const int number = static_cast<int>(i + 1);
    if (line.starts_with("- ") || line.starts_with("+ ") || line == "+") {
      if (mutation.line == 0) mutation.line = number;
      (line[0] == '-' ? mutation.before : mutation.after).push_back(line.size() > 1 ? line.substr(2) : "");
    } else if (line.empty()) {
      end_mutation();
    } else if (!line.starts_with("#") && !line.starts_with("~ ")) {
      end_mutation();
      heading = line;
      text = text_of(tree, heading, number, programs, findings);
    }
  }
  end_mutation();
  return findings;
}

}  // namespace shellmatch::repository
