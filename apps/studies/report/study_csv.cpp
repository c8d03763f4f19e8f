#include "apps/studies/report/study_csv.h"

#include "base/text.h"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <set>

namespace shellmatch {

namespace {

struct Column {
  std::string name;
  std::function<std::string(const StudyRow&)> text;
  bool timing = false;
};

std::string number(double x) { return std::isfinite(x) ? fmt::format("{}", x) : ""; }

// A line break would end the line for many readers, though it is quoted.
std::string text_field(std::string text) {
  for (char& c : text)
    if (c == '\n' || c == '\r') c = ' ';
  return csv_field(text);
}

// The value of a summary's member; empty without a summary.
template <class Get>
auto of_summary(Get get) {
  return [get](const StudyRow& row) { return row.summary ? get(*row.summary) : std::string(); };
}

// Of a run that has been executed.
template <class Get>
auto of_result(Get get) {
  return
      [get](const StudyRow& row) { return row.result.status == RunStatus::not_run ? std::string() : get(row.result); };
}

template <class Get>
auto of_last_level(Get get) {
  return of_summary([get](const MatchSummary& s) { return s.levels.empty() ? std::string() : get(s.levels.back()); });
}

template <class Get>
auto of_distance(Get get) {
  return of_summary([get](const MatchSummary& s) { return s.distance ? number(get(*s.distance)) : std::string(); });
}

long total(const MatchSummary& s, auto member) {
  long sum = 0;
  for (const LevelSummary& level : s.levels) sum += level.*member;
  return sum;
}

double minimisation_seconds(const MatchSummary& s) {
  double sum = 0;
  for (const double t : s.run.level_seconds) sum += t;
  return sum;
}

// The value of the parameter `key` in YAML's notation.
std::string parameter_of(const StudyRow& row, const std::string& key) {
  for (const auto& [name, value] : row.run.parameters)
    if (name == key) return text_field(value);
  return "";
}

using Columns = std::vector<Column>;

void add_identity(Columns& list, const StudyTable& table) {
  list = {{"run", [](const StudyRow& r) { return text_field(r.run.name); }},
          {"problem", [](const StudyRow& r) { return text_field(r.run.problem); }},
          {"solver", [](const StudyRow& r) { return text_field(r.run.solver); }},
          {"method", [](const StudyRow& r) { return r.run.options.solver.name; }},
          {"metric", [](const StudyRow& r) { return r.run.metric; }}};
  for (const std::string& key : table.parameters)
    list.push_back({key, [key](const StudyRow& r) { return parameter_of(r, key); }});
  list.push_back({"repeat", [](const StudyRow& r) { return std::to_string(r.run.repeat); }});
  list.push_back({"status", [](const StudyRow& r) { return status_name(r.result.status); }});
  list.push_back({"exit_code", of_result([](const RunResult& r) { return std::to_string(r.exit_code); })});
  list.push_back(
      {"signal", [](const StudyRow& r) { return r.result.signal == 0 ? "" : std::to_string(r.result.signal); }});
  list.push_back({"max_level", [](const StudyRow& r) { return std::to_string(r.run.options.cascade.max_level); }});
  list.push_back({"level", of_last_level([](const LevelSummary& l) { return std::to_string(l.level); })});
  list.push_back({"free_nodes", of_last_level([](const LevelSummary& l) { return std::to_string(l.n_free_nodes); })});
}

// On the finest level: total, each term that any run has, and the gap to the best.
void add_energies(Columns& list, const StudyTable& table) {
  list.push_back({"energy", [](const StudyRow& r) { return number(r.energy); }});
  std::set<std::string> seen;
  for (const StudyRow& row : table.rows) {
    if (row.finest.empty()) continue;
    for (const auto& [term, unused] : row.summary->levels.back().energy_minimised) {
      if (term == "total" || !seen.insert(term).second) continue;
      list.push_back({"energy_" + term, [term = term](const StudyRow& r) {
                        if (r.finest.empty()) return std::string();
                        for (const auto& [name, value] : r.summary->levels.back().energy_minimised)
                          if (name == term) return number(value);
                        return std::string();
                      }});
    }
  }
  list.push_back({"energy_finer_quadrature", [](const StudyRow& r) {
                    return r.finest.empty() ? std::string()
                                            : number(r.summary->levels.back().energy_reported.back().second);
                  }});
  list.push_back({"best_energy", [](const StudyRow& r) { return number(r.best); }});
  list.push_back({"gap", [](const StudyRow& r) { return number(relative_gap(r.energy, r.best)); }});
}

void add_costs(Columns& list) {
  const auto add_total = [&](const char* name, auto member) {
    list.push_back({name, of_summary([member](const MatchSummary& s) { return std::to_string(total(s, member)); })});
  };
  add_total("iterations", &LevelSummary::iterations);
  add_total("evaluations", &LevelSummary::value_evaluations);
  add_total("gradient_evaluations", &LevelSummary::gradient_evaluations);
  for (std::size_t g = 0; g < study_gaps.size(); ++g) {
    const auto add_cost = [&](const char* name, auto member, bool timing) {
      list.push_back({fmt::format("{}_to_gap_{:g}", name, study_gaps[g]),
                      [g, member](const StudyRow& r) {
                        return r.to_gap[g] ? fmt::format("{}", (*r.to_gap[g]).*member) : std::string();
                      },
                      timing});
    };
    add_cost("evaluations", &GapCost::evaluations, false);
    add_cost("gradient_evaluations", &GapCost::gradient_evaluations, false);
    add_cost("seconds", &GapCost::seconds, true);
  }
}

void add_figures(Columns& list) {
  const auto add_distances = [&](const std::string& name, auto side) {
    list.push_back({name + "_mean", of_distance([side](const TwoSidedDistance& d) { return (d.*side).mean; })});
    list.push_back({name + "_p95", of_distance([side](const TwoSidedDistance& d) { return (d.*side).p95; })});
    list.push_back({name + "_max", of_distance([side](const TwoSidedDistance& d) { return (d.*side).max; })});
  };
  add_distances("deformed_to_template", &TwoSidedDistance::deformed_to_template);
  add_distances("template_to_deformed", &TwoSidedDistance::template_to_deformed);
  list.push_back({"correspondence_error", of_summary([](const MatchSummary& s) {
                    return s.correspondence_error ? number(*s.correspondence_error) : std::string();
                  })});
  list.push_back(
      {"folded_cells", of_last_level([](const LevelSummary& l) { return std::to_string(l.folds.n_folded_cells); })});
  list.push_back(
      {"min_determinant", of_last_level([](const LevelSummary& l) { return number(l.folds.min_determinant); })});
  list.push_back({"flipped_facets", of_summary([](const MatchSummary& s) {
                    return s.n_flipped_facets ? std::to_string(*s.n_flipped_facets) : std::string();
                  })});
  list.push_back({"gradient_norm", of_last_level([](const LevelSummary& l) { return number(l.gradient_norm); })});
  list.push_back({"stop_reason", of_last_level([](const LevelSummary& l) { return l.stop_reason; })});
  list.push_back({"message", [](const StudyRow& r) { return text_field(r.result.message); }});
  list.push_back({"version", [](const StudyRow& r) { return text_field(r.result.program); }});
  list.push_back({"fingerprint", [](const StudyRow& r) { return r.run.fingerprint; }});
}

void add_timings(Columns& list) {
  const auto add = [&](const char* name, std::function<std::string(const StudyRow&)> text) {
    list.push_back({name, std::move(text), true});
  };
  add("seconds", of_result([](const RunResult& r) { return number(r.seconds); }));
  add("minimisation_seconds", of_summary([](const MatchSummary& s) { return number(minimisation_seconds(s)); }));
  add("peak_memory_mb", of_result([](const RunResult& r) {
        return fmt::format("{:.1f}", static_cast<double>(r.peak_memory_bytes) / 1e6);
      }));
  add("threads", of_summary([](const MatchSummary& s) { return std::to_string(s.run.threads); }));
  add("jobs", of_result([](const RunResult& r) { return std::to_string(r.jobs); }));
  add("timings_taken", of_result([](const RunResult& r) { return std::string(r.jobs > 1 ? "in parallel" : "alone"); }));
  add("load", of_result([](const RunResult& r) { return fmt::format("{:.2f}", r.load); }));
  add("machine", [](const StudyRow& r) { return text_field(r.result.machine); });
}

Columns columns(const StudyTable& table) {
  Columns list;
  add_identity(list, table);
  add_energies(list, table);
  add_costs(list);
  add_figures(list);
  add_timings(list);
  return list;
}

}  // namespace

std::string study_csv(const StudyTable& table) {
  const Columns list = columns(table);
  std::string csv;
  for (const Column& column : list) csv += (csv.empty() ? "" : ",") + column.name;
  csv += "\n";
  for (const StudyRow& row : table.rows)
    for (std::size_t c = 0; c < list.size(); ++c) csv += list[c].text(row) + (c + 1 < list.size() ? "," : "\n");
  return csv;
}

std::vector<std::string> study_timing_columns() {
  std::vector<std::string> names;
  for (const Column& column : columns({}))
    if (column.timing) names.push_back(column.name);
  return names;
}

std::string convergence_csv(const StudyTable& table) {
  std::string csv = "run,problem,solver,metric,repeat,iteration,energy,gap,evaluations,gradient_evaluations,seconds\n";
  for (const StudyRow& row : table.rows)
    for (const ConvergencePoint& p : row.finest)
      csv += fmt::format("{},{},{},{},{},{},{},{},{},{},{}\n", text_field(row.run.name), text_field(row.run.problem),
                         text_field(row.run.solver), row.run.metric, row.run.repeat, p.iteration, number(p.value),
                         number(relative_gap(p.value, row.best)), p.evaluations, p.gradient_evaluations, p.seconds);
  return csv;
}

}  // namespace shellmatch
