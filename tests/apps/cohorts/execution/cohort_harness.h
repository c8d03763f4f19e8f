#pragma once
/// \file
/// Cohorts of ellipses, matched by the real program in a fraction of a second each.

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tests/apps/cli_harness.h"

namespace shellmatch {

class CohortProgram : public testing::Test {
 protected:
  void SetUp() override;
  void TearDown() override;

  std::string write(const std::string& name, const std::string& text) const;
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  /// Writes an ellipse of these semi-axes.
  std::string write_ellipse(const std::string& name, double a, double b, int n = 60) const;
  /// Writes ellipses e1.csv to eN.csv, which grow thinner, a table of them in two groups, and returns the name of a
  /// cohort's file. \param atlas the contents of its section
  std::string write_cohort(int n, const std::string& atlas) const;

  ProgramResult cohort(std::vector<std::string> words) const;
  std::string text_of(const std::string& name) const;

  /// Name and checksum of all files of a cohort's folder that are the same in every execution.
  std::map<std::string, std::string> lasting_files(const std::string& folder) const;

  std::filesystem::path folder_;
};

/// The lines of a CSV text by their first column; the head under its own first word.
std::map<std::string, std::string> csv_lines(const std::string& text);

}  // namespace shellmatch
