#include "apps/studies/report/study_report.h"

#include "apps/studies/execution/machine.h"
#include "apps/studies/report/study_csv.h"
#include "apps/studies/report/study_plots.h"
#include "base/error.h"
#include "base/replace_file.h"
#include "base/text.h"
#include "base/types.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>

namespace shellmatch {

namespace fs = std::filesystem;

void collect_study(const Study& study, const std::vector<StudyRun>& runs, const RunsFolder& folder) {
  const StudyTable table = make_study_table(study, runs, folder);
  replace_file(folder.path() + "/table.csv", study_csv(table));
  replace_file(folder.path() + "/convergence.csv", convergence_csv(table));
  const fs::path plots = fs::path(folder.path()) / "plots";
  std::error_code error;
  fs::create_directories(plots, error);
  if (error)
    cannot_be_written(error.value(), fmt::format("{}: cannot be written: {}", plots.string(), error.message()));
  for (const auto& make : {gap_plots, profile_plots, final_plots})
    for (const StudyPlot& plot : make(table))
      replace_file((plots / (plot.name + ".png")).string(),
                   [&](const std::string& partial) { write_plot(plot.plot, partial); });
  replace_file(folder.path() + "/summary.md", study_report(study, table));
  folder.remove_leftovers();  // of processes that have ended since the study began
}

namespace {

using Rows = std::vector<const StudyRow*>;  // the repeats of one method on one instance

std::string with_dash(double x, const char* format) {
  return std::isfinite(x) ? fmt::format(fmt::runtime(format), x) : "-";
}

double median_of(const Rows& rows, auto value) {
  std::vector<double> values;
  for (const StudyRow* row : rows) values.push_back(value(*row));
  return median(values);
}

std::string statuses(const Rows& rows) {
  std::map<std::string, int> counts;
  for (const StudyRow* row : rows) ++counts[status_name(row->result.status)];
  if (counts.size() == 1) return counts.begin()->first;
  std::string text;
  for (const auto& [name, n] : counts) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", n, name);
  return text;
}

// Evaluations and seconds until a gap was reached: "120 / 3.4".
std::string cost_text(const Rows& rows, std::size_t gap) {
  const double evaluations = median_of(rows, [&](const StudyRow& r) {
    return r.to_gap[gap] ? static_cast<double>(r.to_gap[gap]->evaluations) : infinity;
  });
  const double seconds =
      median_of(rows, [&](const StudyRow& r) { return r.to_gap[gap] ? r.to_gap[gap]->seconds : infinity; });
  return std::isfinite(evaluations) ? fmt::format("{:g} / {:.3g}", evaluations, seconds) : "-";
}

std::string method_line(const std::string& method, const Rows& rows) {
  const StudyRow& first = *rows.front();
  const auto& s = first.summary;
  const bool whole = !first.finest.empty();
  long evaluations = 0;
  if (s)
    for (const LevelSummary& level : s->levels) evaluations += level.value_evaluations;
  std::string line = fmt::format("| {} | {} | {} | {} |", method, statuses(rows), with_dash(first.energy, "{:.6g}"),
                                 with_dash(relative_gap(first.energy, first.best), "{:.1e}"));
  line += fmt::format(" {} | {} |", s ? std::to_string(evaluations) : "-",
                      first.result.status == RunStatus::not_run
                          ? "-"
                          : with_dash(median_of(rows, [](const StudyRow& r) { return r.result.seconds; }), "{:.3g}"));
  for (std::size_t g = 0; g < study_gaps.size(); ++g) line += fmt::format(" {} |", cost_text(rows, g));
  line += fmt::format(" {} | {} | {} |\n",
                      whole && s->distance ? fmt::format("{:.2e} / {:.2e}", s->distance->deformed_to_template.mean,
                                                         s->distance->template_to_deformed.mean)
                                           : "-",
                      whole ? std::to_string(s->levels.back().folds.n_folded_cells) : "-",
                      whole ? s->levels.back().stop_reason : "-");
  return line;
}

std::string instance_section(const StudyTable& table, const std::string& instance) {
  std::map<std::string, Rows> by_method;
  Rows order;  // the first repeat of each method
  for (const StudyRow& row : table.rows) {
    if (row.instance != instance) continue;
    Rows& rows = by_method[row.method];
    if (rows.empty()) order.push_back(&row);
    rows.push_back(&row);
  }
  // By ascending energy; runs without an energy come last.
  std::stable_sort(order.begin(), order.end(), [](const StudyRow* a, const StudyRow* b) {
    const auto rank = [](const StudyRow* r) { return std::isfinite(r->energy) ? r->energy : infinity; };
    return rank(a) < rank(b);
  });
  const StudyRow& best = *order.front();
  const ExperimentOptions& options = best.run.options;
  std::string text = fmt::format("\n## {}\n\n", instance);
  const auto shape = [](const std::string& source) {
    return source.starts_with("generate:") ? source : std::filesystem::path(source).filename().string();
  };
  text += fmt::format("`{}` onto `{}`, levels {} to {}", shape(options.input.reference),
                      shape(options.input.template_file), options.cascade.min_level, options.cascade.max_level);
  if (!best.finest.empty()) text += fmt::format(", {} free nodes", best.summary->levels.back().n_free_nodes);
  text += std::isfinite(best.best) ? fmt::format(". Best energy {:.6g}.\n\n", best.best)
                                   : ". No run has reached the finest level.\n\n";
  text += "| method | status | energy | gap | evaluations | seconds |";
  for (const double gap : study_gaps) text += fmt::format(" to gap {:g} |", gap);
  text +=
      " mean distance to / from template | folded cells | stop "
      "|\n|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  for (const StudyRow* row : order) text += method_line(row->method, by_method.at(row->method));
  const std::string file = safe_file_name(instance);
  text += fmt::format(
      "\n![gap against evaluations](plots/gap_evaluations_{}.png)\n![gap against "
      "seconds](plots/gap_seconds_{}.png)\n",
      file, file);
  return text;
}

// Conditions under which the timings were measured.
std::string timing_notes(const StudyTable& table) {
  bool parallel = false, busy = false;
  std::set<std::string> machines, programs;
  for (const StudyRow& row : table.rows) {
    if (row.result.status == RunStatus::not_run) continue;
    parallel |= row.result.jobs > 1;
    const int threads = row.summary ? row.summary->run.threads : 1;
    busy |= row.result.load > row.result.jobs * threads + 0.5;
    machines.insert(row.result.machine);
    programs.insert(row.result.program);
  }
  std::string text;
  if (parallel)
    text += "- **Timings taken in parallel**: runs shared the machine (column `jobs`). Compare evaluations.\n";
  if (busy)
    text +=
        "- **Timings taken on a busy machine**: something else was running (column `load`). Compare "
        "evaluations.\n";
  if (machines.size() > 1) text += "- **Timings of different machines** stand side by side (column `machine`).\n";
  if (programs.size() > 1) text += "- Runs were made by **different versions** of the program (column `version`).\n";
  return text.empty() ? "" : "\n" + text;
}

}  // namespace

std::string study_report(const Study& study, const StudyTable& table) {
  const std::string file = std::filesystem::path(study.file).filename().string();
  std::string text = fmt::format("# {}\n\n", study.options.title.empty() ? "Study " + file : study.options.title);
  std::map<std::string, int> counts;
  std::set<std::string> machines;
  for (const StudyRow& row : table.rows) {
    ++counts[status_name(row.result.status)];
    if (!row.result.machine.empty()) machines.insert(row.result.machine);
  }
  text += fmt::format("{} runs:", table.rows.size());
  for (const auto& [name, n] : counts)
    text += fmt::format("{} {} {}", name == counts.begin()->first ? "" : ",", n, name);
  const RunLimits& limits = study.options.limits;
  text += fmt::format(". Limits of a run: {}, {}.\n",
                      limits.seconds > 0 ? fmt::format("{:g} s", limits.seconds) : "no time limit",
                      limits.memory_mb > 0 ? fmt::format("{:g} MB", limits.memory_mb) : "no memory limit");
  text += timing_notes(table);
  text +=
      "\nA gap is (energy - best) / best, where best is the least energy that any run has found for the same "
      "function: same shapes,\n"
      "levels, weights and coefficients. Costs to a gap are evaluations of the energy (with or without its "
      "gradient) and seconds of\n"
      "minimisation of the whole cascade, until the energy of the last minimisation on the finest level was "
      "within the gap.\n"
      "Second derivatives are no evaluations: where a method uses them, seconds tell more. A method that "
      "brings its own metric is listed without one.\n"
      "Repeats enter by the median. All columns are in table.csv, all steps in convergence.csv.\n";
  for (const std::string& instance : instances_of(table)) text += instance_section(table, instance);

  text +=
      "\n## All problems\n\nPerformance profiles (Dolan and More): the share of problems that a method "
      "solves within so many times the\n"
      "cost of the best method for that problem.\n\n";
  for (const double gap : study_gaps)
    text += fmt::format(
        "![evaluations](plots/profile_evaluations_{:g}.png)\n![seconds](plots/profile_seconds_{:g}.png)\n", gap, gap);
  text += "\n![energy at the end](plots/final_gap.png)\n![distance at the end](plots/final_distance.png)\n";

  std::string failures;
  for (const StudyRow& row : table.rows)
    if (row.result.status != RunStatus::finished)
      failures += fmt::format("- `{}`: {}{}{}\n", row.run.name, status_name(row.result.status),
                              row.result.message.empty() ? "" : ": ", row.result.message);
  if (!failures.empty()) text += "\n## What did not finish\n\nEach has its log in runs/NAME/log.txt.\n\n" + failures;

  text += "\n## Where and with what\n\n";
  for (const std::string& machine : machines) text += fmt::format("- {}\n", machine);
  for (const auto& [name, version] : versions()) text += fmt::format("- {} {}\n", name, version);
  text += fmt::format(
      "\nTo repeat it: `shellmatch study {} -o FOLDER`, with the study.yaml of this folder; one run alone:\n"
      "`shellmatch run runs/NAME/config.yaml -o FOLDER`.\n",
      file);
  return text;
}

}  // namespace shellmatch
