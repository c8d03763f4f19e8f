// `shellmatch --version -v` and docs/licences.md tell the same of what is linked.

#include "matching/progress/linked_libraries.h"
#include "matching/progress/process_info.h"
#include "tests/apps/cli_harness.h"
#include "tests/support/folders.h"

#include <Eigen/Core>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <fstream>
#include <memory>

namespace shellmatch {
namespace {

std::vector<std::string> lines_of(std::istream& in) {
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

// The cells of a row of a Markdown table, without blanks and marks of bold print.
std::vector<std::string> cells_of(const std::string& row) {
  std::vector<std::string> cells;
  for (std::size_t begin = 1, end = 0; (end = row.find('|', begin)) != std::string::npos; begin = end + 1) {
    std::string cell = row.substr(begin, end - begin);
    std::erase(cell, '*');
    cell.erase(0, cell.find_first_not_of(' '));
    cell.erase(cell.find_last_not_of(' ') + 1);
    cells.push_back(cell);
  }
  return cells;
}

TEST(Versions, AreThoseOfTheLinkedLibraries) {
  const ProgramResult plain = run_program({"--version"}), verbose = run_program({"--version", "-v"});
  EXPECT_EQ(plain.exit_code, 0);
  EXPECT_EQ(verbose.exit_code, 0) << verbose.err;
  EXPECT_EQ(run_program({"-v", "--version"}).out, verbose.out);
  EXPECT_EQ(plain.out.find('\n'), plain.out.size() - 1) << "one line, as ever";
  EXPECT_TRUE(has(verbose.out, "\nlicence: GPL-3.0-or-later\n"));
  EXPECT_GE(linked_libraries().size(), 24u);
  for (const LinkedLibrary& library : linked_libraries()) {
    EXPECT_TRUE(has(verbose.out, library.name) && has(verbose.out, library.version) &&
                has(verbose.out, library.licence))
        << library.name;
    EXPECT_TRUE(std::isdigit(static_cast<unsigned char>(library.version[0]))) << library.name << " " << library.version;
  }
}

// CMake packages of other libraries may put all of VTK, with Qt, Java, Python and MPI, among what is linked (ITK 5.4
// does).
TEST(Versions, NothingIsLinkedThatIsNotNeeded) {
  const std::string command = std::string("LD_TRACE_LOADED_OBJECTS=1 '") + SHELLMATCH_PROGRAM + "'";
  const std::unique_ptr<FILE, int (*)(FILE*)> listing(popen(command.c_str(), "r"), pclose);
  ASSERT_TRUE(listing);
  std::string all;
  int n_lines = 0;
  for (char line[4096]; std::fgets(line, sizeof line, listing.get()); ++n_lines) all += line;
  EXPECT_GT(n_lines, 20);
  EXPECT_LT(n_lines, 130) << all;
  for (const char* name : {"libQt", "libjvm", "libpython", "libmpi", "libvtkRendering"})
    EXPECT_FALSE(has(all, name)) << all;
}

TEST(Versions, SayWhichVectorCodeRuns) {
  // Tests are compiled with the flags of the program; Eigen knows what they allow.
  constexpr int n_lanes = Eigen::internal::packet_traits<double>::size;
  const char* units = n_lanes == 8 ? "AVX-512" : n_lanes == 4 ? "AVX" : "SSE2";
  EXPECT_TRUE(vector_code().starts_with(units)) << vector_code() << ", " << n_lanes;
  EXPECT_TRUE(has(run_program({"--version", "-v"}).out, "\nvector code: " + vector_code() + "\n"));
}

TEST(Versions, LicencesAreThoseOfTheDocument) {
  std::ifstream file(test::source_folder() / "docs/licences.md");
  ASSERT_TRUE(file);
  const auto lines = lines_of(file);
  std::size_t n_rows = 0;
  for (const std::string& line : lines) {
    if (!line.starts_with("| ") || line.starts_with("| library") || has(line, "tests only") || has(line, "scripts/") ||
        has(line, "in pictures") || has(line, "Python module") || has(line, "Python package"))
      continue;
    ++n_rows;
    const auto cells = cells_of(line);
    ASSERT_EQ(cells.size(), 4u) << line;
    const auto known =
        std::ranges::find_if(linked_libraries(), [&](const LinkedLibrary& l) { return cells[0].starts_with(l.name); });
    ASSERT_NE(known, linked_libraries().end()) << cells[0];
    EXPECT_TRUE(cells[2].starts_with(known->licence)) << cells[2] << " and " << known->licence;
    EXPECT_EQ(cells[3], known->binds) << cells[0];
  }
  EXPECT_EQ(n_rows, linked_libraries().size());
}

}  // namespace
}  // namespace shellmatch
