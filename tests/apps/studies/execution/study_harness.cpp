#include "tests/apps/studies/execution/study_harness.h"

#include <algorithm>
#include <fstream>
#include <sstream>

#include "apps/studies/report/study_csv.h"

namespace shellmatch {

namespace fs = std::filesystem;

const char* const small_study = R"(version: 1
limits: {seconds: 60}
set:
  threads: 1
  pictures: none
problems:
  leaf:
    set:
      input: {reference: generate:leaf/deep, template: generate:leaf/shallow, placement: as-is}
      cascade: {min_level: 3, max_level: 4}
solvers:
  newton:
  lbfgs:
  paper: {name: fletcher_reeves, stop: {max_iterations: 30}}
metrics: [euclidean, l2]
parameters:
  energy.delta: [1, 0.5]
)";

CsvTable read_table(const fs::path& folder, const std::vector<std::string>& without) {
  std::ifstream in(folder / "table.csv");
  // A quoted field keeps its commas.
  const auto split = [](const std::string& line) {
    std::vector<std::string> fields(1);
    bool quoted = false;
    for (const char c : line) {
      if (c == '"') quoted = !quoted;
      else if (c == ',' && !quoted) fields.emplace_back();
      else fields.back() += c;
    }
    return fields;
  };
  CsvTable table;
  std::string line;
  std::getline(in, line);
  const std::vector<std::string> head = split(line);
  while (std::getline(in, line)) {
    const std::vector<std::string> fields = split(line);
    EXPECT_EQ(fields.size(), head.size()) << line;
    for (std::size_t i = 0; i < std::min(head.size(), fields.size()); ++i)
      if (std::find(without.begin(), without.end(), head[i]) == without.end()) table[fields[0]][head[i]] = fields[i];
  }
  return table;
}

CsvTable lasting_table(const fs::path& folder) { return read_table(folder, study_timing_columns()); }

void StudyProgram::SetUp() {
  folder_ = fs::path(testing::TempDir()) /
            (std::string("shellmatch_study_") + testing::UnitTest::GetInstance()->current_test_info()->name());
  fs::remove_all(folder_);
  fs::create_directories(folder_);
}

void StudyProgram::TearDown() { fs::remove_all(folder_); }

std::string StudyProgram::write(const std::string& name, const std::string& text) const {
  std::ofstream(folder_ / name) << text;
  return path(name);
}

}  // namespace shellmatch
