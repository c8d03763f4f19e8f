#include "studies/report/collect.h"

#include "base/error.h"
#include "matching/output/write_file.h"
#include "studies/report/study_plots.h"
#include "studies/report/study_report.h"
#include "studies/report/study_csv.h"

#include <unistd.h>

#include <filesystem>
#include <functional>

namespace shellmatch {

namespace fs = std::filesystem;

namespace {

// Replaces a file atomically. `write` receives a temporary name in the same folder with the same extension.
void replace(const fs::path& place, const std::function<void(const std::string&)>& write) {
  const fs::path beside =
      place.parent_path() / fmt::format("{}{}-{}", partial_file_prefix, ::getpid(), place.filename().string());
  std::error_code error;
  try {
    write(beside.string());
  } catch (...) {
    fs::remove(beside, error);
    throw;
  }
  fs::rename(beside, place, error);
  if (error) throw_environment_error("{}: cannot be written: {}", place.string(), error.message());
}

}  // namespace

void replace_file(const std::string& path, const std::string& contents) {
  replace(path, [&](const std::string& beside) { write_file(beside, contents); });
}

void collect_study(const Study& study, const std::vector<StudyRun>& runs, const StudyFolder& folder) {
  const StudyTable table = make_study_table(study, runs, folder);
  replace_file(folder.path() + "/table.csv", study_csv(table));
  replace_file(folder.path() + "/convergence.csv", convergence_csv(table));
  const fs::path plots = fs::path(folder.path()) / "plots";
  std::error_code error;
  fs::create_directories(plots, error);
  if (error) throw_environment_error("{}: cannot be written: {}", plots.string(), error.message());
  for (const auto& make : {gap_plots, profile_plots, final_plots})
    for (const StudyPlot& plot : make(table))
      replace(plots / (plot.name + ".png"),
              [&](const std::string& beside) { write_plot(plot.plot, beside); });
  replace_file(folder.path() + "/summary.md", study_report(study, table));
  folder.remove_leftovers();  // of processes that have ended since the study began
}

}  // namespace shellmatch
