#include "apps/studies/report/collect.h"

#include "base/error.h"
#include "base/replace_file.h"
#include "apps/studies/report/study_plots.h"
#include "apps/studies/report/study_report.h"
#include "apps/studies/report/study_csv.h"

#include <filesystem>

namespace shellmatch {

namespace fs = std::filesystem;

void collect_study(const Study& study, const std::vector<StudyRun>& runs, const RunsFolder& folder) {
  const StudyTable table = make_study_table(study, runs, folder);
  replace_file(folder.path() + "/table.csv", study_csv(table));
  replace_file(folder.path() + "/convergence.csv", convergence_csv(table));
  const fs::path plots = fs::path(folder.path()) / "plots";
  std::error_code error;
  fs::create_directories(plots, error);
  if (error) throw_environment_error("{}: cannot be written: {}", plots.string(), error.message());
  for (const auto& make : {gap_plots, profile_plots, final_plots})
    for (const StudyPlot& plot : make(table))
      replace_file((plots / (plot.name + ".png")).string(),
                   [&](const std::string& partial) { write_plot(plot.plot, partial); });
  replace_file(folder.path() + "/summary.md", study_report(study, table));
  folder.remove_leftovers();  // of processes that have ended since the study began
}

}  // namespace shellmatch
