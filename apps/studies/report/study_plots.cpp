#include "apps/studies/report/study_plots.h"

#include "apps/studies/report/convergence.h"
#include "base/error.h"
#include "base/text.h"
#include "base/types.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace shellmatch {

namespace {

void append_new(std::vector<std::string>& list, const std::string& name) {
  if (std::find(list.begin(), list.end(), name) == list.end()) list.push_back(name);
}

// One colour for each solver, one dash pattern for each of its variants (metric, parameters).
class Styles {
 public:
  explicit Styles(const StudyTable& table) {
    for (const StudyRow& row : table.rows) {
      const auto solver = solvers_.try_emplace(row.run.solver, static_cast<int>(solvers_.size())).first->second;
      std::map<std::string, int>& variants = variants_[row.run.solver];
      const int variant = variants.try_emplace(row.method, static_cast<int>(variants.size())).first->second;
      styles_[row.method] = {solver % 8, (variant + 3 * (solver / 8)) % 6};
    }
  }
  Series series(const std::string& method) const {
    const auto& [color, dashes] = styles_.at(method);
    return {.name = method, .x = {}, .y = {}, .color = color, .dashes = dashes};
  }

 private:
  std::map<std::string, int> solvers_;
  std::map<std::string, std::map<std::string, int>> variants_;
  std::map<std::string, std::pair<int, int>> styles_;
};

// The height in pixels that the legend needs.
int height_for(std::size_t n_entries) { return std::max(560, 130 + static_cast<int>(21 * n_entries)); }

// Evaluations or seconds until the gap was reached, by instance and method; infinity if it was not.
std::vector<std::vector<double>> costs_to_gap(const StudyTable& table, std::size_t gap, bool seconds) {
  const std::vector<std::string> instances = instances_of(table), methods = methods_of(table);
  std::vector<std::vector<double>> costs;
  for (const std::string& instance : instances) {
    std::vector<double>& row = costs.emplace_back();
    for (const std::string& method : methods) {
      std::vector<double> repeats;
      for (const StudyRow& r : table.rows) {
        if (r.instance != instance || r.method != method) continue;
        const auto& cost = r.to_gap[gap];
        const double c = !cost ? infinity : seconds ? cost->seconds : static_cast<double>(cost->evaluations);
        repeats.push_back(std::max(c, 1e-9));
      }
      row.push_back(repeats.empty() ? infinity : median(repeats));
    }
  }
  return costs;
}

}  // namespace

double median(std::vector<double> values) {
  SHELLMATCH_CHECK(!values.empty(), "a median needs values");
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return n % 2 == 1 ? values[n / 2] : values[n / 2 - 1] + 0.5 * (values[n / 2] - values[n / 2 - 1]);
}

std::vector<std::string> instances_of(const StudyTable& table) {
  std::vector<std::string> names;
  for (const StudyRow& row : table.rows) append_new(names, row.instance);
  return names;
}

std::vector<std::string> methods_of(const StudyTable& table) {
  std::vector<std::string> names;
  for (const StudyRow& row : table.rows) append_new(names, row.method);
  return names;
}

std::vector<StudyPlot> gap_plots(const StudyTable& table) {
  const Styles styles(table);
  std::vector<StudyPlot> plots;
  for (const std::string& instance : instances_of(table))
    for (const bool seconds : {false, true}) {
      Plot plot{
          .title = instance,
          .x_label = seconds ? "seconds of minimisation, whole cascade" : "evaluations of the energy, whole cascade",
          .y_label = "relative gap to the best energy",
          .log_x = true,
          .log_y = true};
      for (const StudyRow& row : table.rows) {
        if (row.instance != instance || row.run.repeat != 1 || row.finest.empty()) continue;
        Series series = styles.series(row.method);
        for (const ConvergencePoint& p : row.finest) {
          series.x.push_back(seconds ? p.seconds : static_cast<double>(p.evaluations));
          series.y.push_back(std::max(relative_gap(p.value, row.best), least_gap_shown));
        }
        plot.series.push_back(std::move(series));
      }
      plot.height = height_for(plot.series.size());
      plots.push_back(
          {fmt::format("gap_{}_{}", seconds ? "seconds" : "evaluations", safe_file_name(instance)), std::move(plot)});
    }
  return plots;
}

std::vector<StudyPlot> profile_plots(const StudyTable& table) {
  const Styles styles(table);
  const std::vector<std::string> methods = methods_of(table);
  std::vector<StudyPlot> plots;
  for (const bool seconds : {false, true})
    for (std::size_t g = 0; g < study_gaps.size(); ++g) {
      const auto profiles = performance_profiles(costs_to_gap(table, g, seconds));
      const std::string what = seconds ? "seconds" : "evaluations";
      Plot plot{.title = fmt::format("{} to a gap of {:g}", seconds ? "Seconds" : "Evaluations", study_gaps[g]),
                .x_label = fmt::format("{} over those of the fastest", what),
                .y_label = "share of the problems",
                .log_x = true};
      double end = 2;
      for (const PerformanceProfile& profile : profiles) end = std::max(end, 1.1 * profile.ratio.back());
      for (std::size_t m = 0; m < profiles.size(); ++m) {
        Series series = styles.series(methods[m]);
        double share = 0;
        for (std::size_t i = 0; i < profiles[m].ratio.size(); ++i) {
          series.x.insert(series.x.end(), 2, profiles[m].ratio[i]);
          series.y.insert(series.y.end(), {i == 0 ? profiles[m].share[0] : share, profiles[m].share[i]});
          share = profiles[m].share[i];
        }
        series.x.push_back(end);
        series.y.push_back(share);
        plot.series.push_back(std::move(series));
      }
      plot.height = height_for(plot.series.size());
      plots.push_back({fmt::format("profile_{}_{:g}", what, study_gaps[g]), std::move(plot)});
    }
  return plots;
}

std::vector<StudyPlot> final_plots(const StudyTable& table) {
  const std::vector<std::string> methods = methods_of(table);
  std::vector<StudyPlot> plots;
  for (const bool distance : {false, true}) {
    Plot plot{.title = distance ? "Distance at the end" : "Energy at the end",
              .x_label = distance ? "mean distance, both ways, in diagonals of the template"
                                  : "relative gap to the best energy",
              .y_label = "",
              .log_x = true};
    plot.rows = methods;
    for (const std::string& instance : instances_of(table)) {
      Series series{.name = instance, .x = {}, .y = {}, .points = true, .line = false};
      for (const StudyRow& row : table.rows) {
        if (row.instance != instance || row.run.repeat != 1 || row.finest.empty()) continue;
        const auto& d = row.summary->distance;
        if (distance && !d) continue;
        series.x.push_back(distance ? 0.5 * (d->deformed_to_template.mean + d->template_to_deformed.mean)
                                    : std::max(relative_gap(row.energy, row.best), least_gap_shown));
        series.y.push_back(
            static_cast<double>(std::find(methods.begin(), methods.end(), row.method) - methods.begin()));
      }
      plot.series.push_back(std::move(series));
    }
    plot.height = std::max(300, 130 + static_cast<int>(24 * methods.size()));
    plots.push_back({distance ? "final_distance" : "final_gap", std::move(plot)});
  }
  return plots;
}

}  // namespace shellmatch
