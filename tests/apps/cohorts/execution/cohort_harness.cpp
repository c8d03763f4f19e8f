#include "tests/apps/cohorts/execution/cohort_harness.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

#include "matching/output/checksum.h"

namespace shellmatch {

namespace fs = std::filesystem;

void CohortProgram::SetUp() {
  folder_ = fs::path(testing::TempDir()) /
            (std::string("shellmatch_cohort_") + testing::UnitTest::GetInstance()->current_test_info()->name());
  fs::remove_all(folder_);
  fs::create_directories(folder_);
}

void CohortProgram::TearDown() { fs::remove_all(folder_); }

std::string CohortProgram::write(const std::string& name, const std::string& text) const {
  std::ofstream(folder_ / name) << text;
  return path(name);
}

std::string CohortProgram::write_ellipse(const std::string& name, double a, double b, int n) const {
  std::string text = "x,y\n";
  for (int k = 0; k < n; ++k) {
    const double t = 2 * std::numbers::pi * k / n;
    text += fmt::format("{},{}\n", a * std::cos(t), b * std::sin(t));
  }
  return write(name, text);
}

std::string CohortProgram::write_cohort(int n, const std::string& atlas) const {
  std::string table = "id,file,group,age\n";
  for (int k = 1; k <= n; ++k) {
    write_ellipse(fmt::format("e{}.csv", k), 1 + 0.02 * k, 0.9 - 0.04 * k, 50 + k);
    table += fmt::format("e{0},e{0}.csv,{1},{2}\n", k, 2 * k <= n ? "thick" : "thin", 20 + k);
  }
  write("table.csv", table);
  return write("cohort.yaml", fmt::format(R"(version: 1
title: Ellipses
table: table.csv
atlas: {}
statistics: {{permutations: 50, samples: 50, mode_meshes: 1}}
set:
  pictures: none
  report: false
  align: {{mode: none}}
  cascade: {{min_level: 3, max_level: 4}}
)",
                                          atlas));
}

ProgramResult CohortProgram::cohort(std::vector<std::string> words) const {
  words.insert(words.begin(), "cohort");
  return run_program(words, folder_.string());
}

std::string CohortProgram::text_of(const std::string& name) const {
  std::ifstream in(folder_ / name, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

std::map<std::string, std::string> CohortProgram::lasting_files(const std::string& folder) const {
  std::map<std::string, std::string> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder_ / folder)) {
    const std::string name = fs::relative(entry.path(), folder_ / folder).string(),
                      last = entry.path().filename().string();
    // Times, the machine and paths of the folder stand in these; what was left aside by a kill is not there at all.
    if (!entry.is_regular_file() || last == "times.csv" || last == "result.json" || last == "log.txt" ||
        last == "config.yaml" || last == "history.csv" || last == "files.json" ||
        (last == "summary.json" && name != "summary.json") || name.starts_with(".stages"))
      continue;
    files[name] = text_checksum(text_of(folder + "/" + name));
  }
  return files;
}

std::map<std::string, std::string> csv_lines(const std::string& text) {
  std::map<std::string, std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines[line.substr(0, line.find(','))] = line;
  return lines;
}

}  // namespace shellmatch
