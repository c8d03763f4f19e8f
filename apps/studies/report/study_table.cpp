#include "apps/studies/report/study_table.h"

#include "base/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <set>

namespace shellmatch {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// The parameters on which the minimised function depends: those that change the energy key while all else is equal.
std::set<std::string> energy_parameters(const std::vector<StudyRun>& runs) {
  std::set<std::string> found;
  for (std::size_t axis = 0; !runs.empty() && axis < runs.front().parameters.size(); ++axis) {
    std::map<std::string, std::string> key_of_rest;
    for (const StudyRun& run : runs) {
      std::string rest = fmt::format("{}|{}|{}|{}", run.problem, run.solver, run.metric, run.repeat);
      for (std::size_t k = 0; k < run.parameters.size(); ++k)
        if (k != axis) rest += "|" + run.parameters[k].second;
      if (key_of_rest.try_emplace(rest, run.energy_key).first->second != run.energy_key)
        found.insert(run.parameters[axis].first);
    }
  }
  return found;
}

StudyRow read_row(const StudyRun& run, const RunsFolder& folder) {
  StudyRow row;
  row.run = run;
  row.result = folder.result_of(run);
  row.energy = nan;
  const std::string output = folder.run_folder(run) + "/output";
  if (row.result.status == RunStatus::not_run || !std::filesystem::exists(output + "/summary.json")) return row;
  try {
    row.summary = read_summary(output + "/summary.json");
    row.finest = finest_convergence(read_history(output + "/history.csv"), *row.summary, run.options.cascade.max_level);
  } catch (const InputError& error) {
    // One damaged result must not hide the others.
    row.summary.reset();
    row.result.status = RunStatus::failed;
    row.result.message = fmt::format("its result cannot be read: {}", error.what());
    return row;
  }
  if (!row.finest.empty() && !row.summary->levels.back().energy_minimised.empty())
    row.energy = row.summary->levels.back().energy_minimised.back().second;
  return row;
}

}  // namespace

StudyTable make_study_table(const Study& study, const std::vector<StudyRun>& runs, const RunsFolder& folder) {
  StudyTable table;
  for (const StudyParameter& parameter : study.parameters) table.parameters.push_back(parameter.key);
  const std::set<std::string> changing = energy_parameters(runs);
  std::map<std::string, double> best;
  for (const StudyRun& run : runs) {
    StudyRow row = read_row(run, folder);
    row.instance = run.problem;
    row.method = run.method();
    for (const auto& [key, value] : run.parameters)
      (changing.contains(key) ? row.instance : row.method) += fmt::format(" {}={}", key, value);
    double& least = best.try_emplace(run.energy_key, nan).first->second;
    least = std::fmin(least, row.energy);
    for (const ConvergencePoint& p : row.finest)
      if (std::isfinite(p.value)) least = std::fmin(least, p.value);
    table.rows.push_back(std::move(row));
  }
  for (StudyRow& row : table.rows) {
    row.best = best.at(row.run.energy_key);
    for (std::size_t g = 0; g < study_gaps.size(); ++g)
      row.to_gap[g] = cost_to_gap(row.finest, row.best, study_gaps[g]);
  }
  return table;
}

}  // namespace shellmatch
