#include "matching/output/history_file.h"

#include "base/error.h"
#include "matching/output/write_file.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <iterator>
#include <string_view>

namespace shellmatch {

namespace {

constexpr std::string_view before_terms[] = {"level", "substep", "nu", "solver", "iteration", "value"};
constexpr std::string_view after_terms[] = {"gradient_norm",     "l2_gradient_norm",     "step",
                                            "value_evaluations", "gradient_evaluations", "seconds"};

std::vector<std::string_view> split(std::string_view line) {
  std::vector<std::string_view> fields;
  for (;;) {
    const std::size_t comma = line.find(',');
    fields.push_back(line.substr(0, comma));
    if (comma == std::string_view::npos) return fields;
    line.remove_prefix(comma + 1);
  }
}

template <class Number>
Number parse(std::string_view text, const std::string& path, int line) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size())
    throw_input_error("{}, line {}: '{}' is not a number; the file is damaged", path, line, text);
  return number;
}

std::vector<std::string> term_names_of(std::string_view header, const std::string& path) {
  const std::vector<std::string_view> names = split(header);
  const std::size_t n_before = std::size(before_terms), n_after = std::size(after_terms);
  bool good = names.size() >= n_before + n_after;
  for (std::size_t i = 0; good && i < n_before; ++i) good = names[i] == before_terms[i];
  for (std::size_t i = 0; good && i < n_after; ++i) good = names[names.size() - n_after + i] == after_terms[i];
  if (!good)
    throw_input_error("{}, line 1: not the head line of a history; give the history.csv of an output folder", path);
  return {names.begin() + n_before, names.end() - n_after};
}

}  // namespace

std::string history_csv(const History& history) {
  std::string csv;
  for (const std::string_view name : before_terms) csv += fmt::format("{},", name);
  for (const std::string& name : history.term_names) csv += fmt::format("{},", name);
  for (const std::string_view name : after_terms) csv += fmt::format("{}{}", name, name == "seconds" ? "\n" : ",");
  for (const HistoryRow& row : history.rows) {
    const IterationRecord& r = row.record;
    SHELLMATCH_CHECK(r.terms.size() == history.term_names.size(), "a history's line has a value for each term");
    csv += fmt::format("{},{},{},{},{},{},", row.level, row.substep, row.nu, r.solver, r.iteration, r.value);
    for (const double term : r.terms) csv += fmt::format("{},", term);
    csv += fmt::format("{},{},{},{},{},{}\n", r.gradient_norm, r.l2_gradient_norm, r.step, r.value_evaluations,
                       r.gradient_evaluations, r.seconds);
  }
  return csv;
}

void write_history(const History& history, const std::string& path) { write_file(path, history_csv(history)); }

History read_history(const std::string& path) {
  std::ifstream in(path);
  if (!in) throw_input_error("{}: cannot be read; give the history.csv of an output folder", path);
  History history;
  std::string text;
  std::getline(in, text);
  history.term_names = term_names_of(text, path);
  const std::size_t n_fields = std::size(before_terms) + history.term_names.size() + std::size(after_terms);
  for (int line = 2; std::getline(in, text); ++line) {
    const std::vector<std::string_view> fields = split(text);
    if (fields.size() != n_fields)
      throw_input_error("{}, line {}: {} values where {} belong; the file is damaged", path, line, fields.size(),
                        n_fields);
    std::size_t next = 0;
    const auto real = [&] { return parse<double>(fields[next++], path, line); };
    const auto integer = [&] { return parse<int>(fields[next++], path, line); };
    const auto count = [&] { return parse<long>(fields[next++], path, line); };
    HistoryRow row;
    row.level = integer();
    row.substep = integer();
    row.nu = real();
    row.record.solver = fields[next++];
    row.record.iteration = integer();
    row.record.value = real();
    for (std::size_t k = 0; k < history.term_names.size(); ++k) row.record.terms.push_back(real());
    row.record.gradient_norm = real();
    row.record.l2_gradient_norm = real();
    row.record.step = real();
    row.record.value_evaluations = count();
    row.record.gradient_evaluations = count();
    row.record.seconds = real();
    history.rows.push_back(std::move(row));
  }
  return history;
}

Plot energy_plot(const History& history, bool over_seconds) {
  Plot plot{.title = "Energy",
            .x_label = over_seconds ? "seconds of minimisation" : "accepted steps",
            .y_label = "energy",
            .log_y = true};
  plot.series.resize(1 + history.term_names.size());
  plot.series[0].name = "sum";
  for (std::size_t k = 0; k < history.term_names.size(); ++k) plot.series[k + 1].name = history.term_names[k];
  double finished = 0, steps = 0;  // totals of the earlier minimisations
  for (std::size_t i = 0; i < history.rows.size(); ++i) {
    const HistoryRow& row = history.rows[i];
    if (i > 0) {
      const HistoryRow& last = history.rows[i - 1];
      if (row.level != last.level || row.substep != last.substep) {
        finished += last.record.seconds;
        plot.marks.push_back(over_seconds ? finished : steps);
        // Another nu changes the energy, so the lines are interrupted.
        for (Series& s : plot.series) {
          s.x.push_back(plot.marks.back());
          s.y.push_back(0);
        }
      } else {
        ++steps;
      }
    }
    const double x = over_seconds ? finished + row.record.seconds : steps;
    plot.series[0].x.push_back(x);
    plot.series[0].y.push_back(row.record.value);
    for (std::size_t k = 0; k < row.record.terms.size(); ++k) {
      plot.series[k + 1].x.push_back(x);
      plot.series[k + 1].y.push_back(row.record.terms[k]);
    }
  }
  // Bending and membrane terms start with rounding errors, which would take up most of the logarithmic axis.
  double largest = 0;
  for (const double value : plot.series[0].y) largest = std::max(largest, value);
  for (Series& s : plot.series)
    for (double& value : s.y) value = value < 1e-8 * largest ? 0 : value;
  return plot;
}

}  // namespace shellmatch
