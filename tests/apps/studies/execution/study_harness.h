#pragma once
/// \file
/// Studies run by the real program, and their tables.

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tests/apps/cli_harness.h"

namespace shellmatch {

/// By run, then by column.
using CsvTable = std::map<std::string, std::map<std::string, std::string>>;

/// Reads table.csv. \param without columns that are left out
CsvTable read_table(const std::filesystem::path& folder, const std::vector<std::string>& without = {});

/// Without what differs from one time to the next.
CsvTable lasting_table(const std::filesystem::path& folder);

class StudyProgram : public testing::Test {
 protected:
  void SetUp() override;
  void TearDown() override;
  std::string write(const std::string& name, const std::string& text) const;
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  std::filesystem::path folder_;
};

/// Runs in the plane on coarse grids, a fraction of a second each.
extern const char* const small_study;

}  // namespace shellmatch
