// Writes pages of cohorts, and beside each what it should show: cohort_pages FOLDER

#include "apps/cohorts/report/cohort_report.h"
#include "matching/output/write_file.h"
#include "tests/apps/cohorts/report/cohort_samples.h"

#include <fmt/format.h>

#include <cstdio>
#include <utility>

namespace {

using namespace shellmatch;

// The coordinates of the subjects in the statistics, one line each: the id and x, y(, z) of all points.
template <int Dim>
void write_page(const std::string& name, const CohortResult<Dim>& result) {
  write_file(name + ".html", cohort_report_html(result));
  std::string lines;
  for (std::size_t c = 0; c < result.rows.size(); ++c) {
    lines += result.subjects[result.rows[c]].id;
    for (const double x : result.aligned.coordinates.col(static_cast<Eigen::Index>(c)))
      lines += fmt::format(" {:.9g}", x);
    lines += '\n';
  }
  write_file(name + ".txt", lines);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: cohort_pages FOLDER\n", stderr);
    return 2;
  }
  const std::string folder = std::string(argv[1]) + "/";
  CohortResult<3> space = test::sample_cohort<3>();
  space.subjects[8].id = "</script><b>09";  // stays a name
  space.subjects[8].folder = "runs/a b#?/output";
  write_page(folder + "space", space);
  write_page(folder + "plane", test::sample_cohort<2>({.n_points = 240}));
  write_page(folder + "one", test::sample_cohort<3>({.n_subjects = 1, .has_failures = false}));
  CohortResult<2> none = test::sample_cohort<2>({.n_subjects = 0, .has_failures = false});
  none.rounds.clear();
  none.unit.clear();
  none.subjects = {test::unfinished_subject("lost", "crashed", "signal 11"),
                   test::unfinished_subject("later", "not_run")};
  write_page(folder + "none", none);
  CohortResult<3> large = test::sample_cohort<3>({.n_subjects = 40, .n_points = 5000});
  large.difference.reset();
  for (SubjectResult& s : large.subjects) s.group.clear();
  write_file(folder + "large.html", cohort_report_html(large));
}
