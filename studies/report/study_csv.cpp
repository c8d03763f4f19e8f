#include "studies/report/study_csv.h"

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

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"') result += '"';
    result += c == '\n' || c == '\r' ? ' ' : c;
  }
  return result + "\"";
}

// The value of a summary's member; empty without a summary.
template <class Get>
auto of_summary(Get get) {
  return [get](const StudyRow& row) { return row.summary ? get(*row.summary) : std::string(); };
}

template <class Get>
auto of_last_level(Get get) {
  return of_summary(
      [get](const MatchSummary& s) { return s.levels.empty() ? std::string() : get(s.levels.back()); });
}

template <class Get>
auto of_distance(Get get) {
  return of_summary(
      [get](const MatchSummary& s) { return s.distance ? number(get(*s.distance)) : std::string(); });
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
    if (name == key) return quoted(value);
  return "";
}

std::vector<Column> columns(const StudyTable& table) {
  std::vector<Column> list = {{"run", [](const StudyRow& r) { return r.run.name; }},
                              {"problem", [](const StudyRow& r) { return r.run.problem; }},
                              {"solver", [](const StudyRow& r) { return r.run.solver; }},
                              {"method", [](const StudyRow& r) { return r.run.options.solver.name; }},
                              {"metric", [](const StudyRow& r) { return r.run.metric; }}};
  for (const std::string& key : table.parameters)
    list.push_back({key, [key](const StudyRow& r) { return parameter_of(r, key); }});
  const auto add = [&](std::string name, std::function<std::string(const StudyRow&)> text,
                       bool timing = false) {
    list.push_back({std::move(name), std::move(text), timing});
  };
  add("repeat", [](const StudyRow& r) { return std::to_string(r.run.repeat); });
  add("status", [](const StudyRow& r) { return status_name(r.result.status); });
  add("exit_code", [](const StudyRow& r) {
    return r.result.status == RunStatus::not_run ? "" : std::to_string(r.result.exit_code);
  });
  add("signal",
      [](const StudyRow& r) { return r.result.signal == 0 ? "" : std::to_string(r.result.signal); });
  add("max_level", [](const StudyRow& r) { return std::to_string(r.run.options.cascade.max_level); });
  add("level", of_last_level([](const LevelSummary& l) { return std::to_string(l.level); }));
  add("free_nodes", of_last_level([](const LevelSummary& l) { return std::to_string(l.n_free_nodes); }));
  add("energy", [](const StudyRow& r) { return number(r.energy); });
  std::set<std::string> seen;
  for (const StudyRow& row : table.rows) {
    if (row.finest.empty()) continue;
    for (const auto& [term, unused] : row.summary->levels.back().energy_minimised) {
      if (term == "total" || !seen.insert(term).second) continue;
      add("energy_" + term, [term = term](const StudyRow& r) {
        if (r.finest.empty()) return std::string();
        for (const auto& [name, value] : r.summary->levels.back().energy_minimised)
          if (name == term) return number(value);
        return std::string();
      });
    }
  }
  add("energy_finer_quadrature", [](const StudyRow& r) {
    return r.finest.empty() ? std::string() : number(r.summary->levels.back().energy_reported.back().second);
  });
  add("best_energy", [](const StudyRow& r) { return number(r.best); });
  add("gap", [](const StudyRow& r) { return number(relative_gap(r.energy, r.best)); });
  add("iterations",
      of_summary([](const MatchSummary& s) { return std::to_string(total(s, &LevelSummary::iterations)); }));
  add("evaluations", of_summary([](const MatchSummary& s) {
        return std::to_string(total(s, &LevelSummary::value_evaluations));
      }));
  add("gradient_evaluations", of_summary([](const MatchSummary& s) {
        return std::to_string(total(s, &LevelSummary::gradient_evaluations));
      }));
  for (std::size_t g = 0; g < study_gaps.size(); ++g) {
    const auto cost = [&](const char* name, auto get, bool timing) {
      add(
          fmt::format("{}_to_gap_{:g}", name, study_gaps[g]),
          [g, get](const StudyRow& r) {
            return r.to_gap[g] ? fmt::format("{}", get(*r.to_gap[g])) : std::string();
          },
          timing);
    };
    cost(
        "evaluations", [](const GapCost& c) { return c.evaluations; }, false);
    cost(
        "gradient_evaluations", [](const GapCost& c) { return c.gradient_evaluations; }, false);
    cost(
        "seconds", [](const GapCost& c) { return c.seconds; }, true);
  }
  const auto one_sided = [&](const std::string& name, auto side) {
    add(name + "_mean", of_distance([side](const TwoSidedDistance& d) { return (d.*side).mean; }));
    add(name + "_p95", of_distance([side](const TwoSidedDistance& d) { return (d.*side).p95; }));
    add(name + "_max", of_distance([side](const TwoSidedDistance& d) { return (d.*side).max; }));
  };
  one_sided("deformed_to_template", &TwoSidedDistance::deformed_to_template);
  one_sided("template_to_deformed", &TwoSidedDistance::template_to_deformed);
  add("correspondence_error", of_summary([](const MatchSummary& s) {
        return s.correspondence_error ? number(*s.correspondence_error) : std::string();
      }));
  add("folded_cells",
      of_last_level([](const LevelSummary& l) { return std::to_string(l.folds.n_folded_cells); }));
  add("min_determinant",
      of_last_level([](const LevelSummary& l) { return number(l.folds.min_determinant); }));
  add("flipped_facets", of_summary([](const MatchSummary& s) {
        return s.n_flipped_facets ? std::to_string(*s.n_flipped_facets) : std::string();
      }));
  add("gradient_norm", of_last_level([](const LevelSummary& l) { return number(l.gradient_norm); }));
  add("stop_reason", of_last_level([](const LevelSummary& l) { return l.stop_reason; }));
  add("message", [](const StudyRow& r) { return quoted(r.result.message); });
  add("version", [](const StudyRow& r) { return r.result.program; });
  add("fingerprint", [](const StudyRow& r) { return r.run.fingerprint; });
  add(
      "seconds",
      [](const StudyRow& r) { return r.result.status == RunStatus::not_run ? "" : number(r.result.seconds); },
      true);
  add("minimisation_seconds",
      of_summary([](const MatchSummary& s) { return number(minimisation_seconds(s)); }), true);
  add(
      "peak_memory_mb",
      [](const StudyRow& r) {
        return r.result.status == RunStatus::not_run
                   ? ""
                   : fmt::format("{:.1f}", static_cast<double>(r.result.peak_memory_bytes) / 1e6);
      },
      true);
  add("threads", of_summary([](const MatchSummary& s) { return std::to_string(s.run.threads); }), true);
  add(
      "jobs",
      [](const StudyRow& r) {
        return r.result.status == RunStatus::not_run ? "" : std::to_string(r.result.jobs);
      },
      true);
  add(
      "timings_taken",
      [](const StudyRow& r) {
        return r.result.status == RunStatus::not_run ? "" : r.result.jobs > 1 ? "in parallel" : "alone";
      },
      true);
  add(
      "load",
      [](const StudyRow& r) {
        return r.result.status == RunStatus::not_run ? "" : fmt::format("{:.2f}", r.result.load);
      },
      true);
  add(
      "machine", [](const StudyRow& r) { return quoted(r.result.machine); }, true);
  return list;
}

}  // namespace

std::string study_csv(const StudyTable& table) {
  const std::vector<Column> list = columns(table);
  std::string csv;
  for (const Column& column : list) csv += (csv.empty() ? "" : ",") + column.name;
  csv += "\n";
  for (const StudyRow& row : table.rows)
    for (std::size_t c = 0; c < list.size(); ++c)
      csv += list[c].text(row) + (c + 1 < list.size() ? "," : "\n");
  return csv;
}

std::vector<std::string> study_timing_columns() {
  std::vector<std::string> names;
  for (const Column& column : columns({}))
    if (column.timing) names.push_back(column.name);
  return names;
}

std::string convergence_csv(const StudyTable& table) {
  std::string csv =
      "run,problem,solver,metric,repeat,iteration,energy,gap,evaluations,gradient_evaluations,seconds\n";
  for (const StudyRow& row : table.rows)
    for (const ConvergencePoint& p : row.finest)
      csv += fmt::format("{},{},{},{},{},{},{},{},{},{},{}\n", row.run.name, row.run.problem, row.run.solver,
                         row.run.metric, row.run.repeat, p.iteration, number(p.value),
                         number(relative_gap(p.value, row.best)), p.evaluations, p.gradient_evaluations,
                         p.seconds);
  return csv;
}

}  // namespace shellmatch
