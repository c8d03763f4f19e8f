#include "matching/derivative_check/gradient_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

namespace shellmatch {

std::string_view name_of(TermCheck::State state) {
  switch (state) {
    case TermCheck::State::passed: return "passed";
    case TermCheck::State::failed: return "failed";
    case TermCheck::State::off: return "off";
    case TermCheck::State::inactive: return "inactive";
    case TermCheck::State::vanishing: return "vanishing";
  }
  return "?";
}

namespace {

std::string orders_text(const TermCheck& t) {
  std::string text;
  for (const DirectionCheck& d : t.directions)
    text += (text.empty() ? "" : " | ") +
            (d.resolved ? fmt::format("{:.3f}", fmt::join(d.orders, " ")) : std::string("unresolved"));
  return text;
}

using Row = std::array<std::string, 8>;

Row row_of(const TermCheck& t) {
  const std::string state(t.state == TermCheck::State::failed ? "FAILED" : name_of(t.state));
  if (t.state == TermCheck::State::off || t.state == TermCheck::State::inactive)
    return {t.name, "", "", "", "", "", "", state};
  const std::string ceres =
      t.ceres.n_elements > 0 ? fmt::format("{:.0e} ({})", t.ceres.worst_relative_error, t.ceres.n_elements) : "-";
  return {t.name,
          fmt::format("{:.4e}", t.value),
          fmt::format("{:.2e}", t.gradient_norm),
          orders_text(t),
          fmt::format("{:.0e}", std::max(t.gradient_error, t.value_error)),
          fmt::format("{:.0e} ({})", t.difference_error, t.n_differenced),
          ceres,
          state};
}

std::string table(const GradientReport& report) {
  std::vector<Row> rows = {{"term", "value", "|gradient|", "order of the Taylor remainder, by decade", "functors",
                            "differences", "Ceres", ""}};
  for (const TermCheck& t : report.terms) rows.push_back(row_of(t));
  Row::size_type widths[8] = {};
  for (const Row& row : rows)
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], row[c].size());
  std::string text;
  for (const Row& row : rows) {
    std::string line;
    for (std::size_t c = 0; c < row.size(); ++c) line += fmt::format("{:<{}}  ", row[c], widths[c]);
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + '\n';
  }
  return text;
}

std::string remarks(const TermCheck& t) {
  std::string text;
  const auto say = [&](const std::string& what) { text += fmt::format("  {}: {}\n", t.name, what); };
  for (const std::string& fault : t.faults) say("FAILED: " + fault);
  if (t.state == TermCheck::State::inactive) say("acts on no element at this deformation: nothing was checked");
  if (t.state == TermCheck::State::vanishing)
    say("the gradient is zero but for rounding: a wrong factor would not show; check at another deformation as well");
  for (const std::string& note : t.notes) say(note);
  for (std::size_t d = 0; d < t.directions.size(); ++d) {
    const DirectionCheck& c = t.directions[d];
    std::string line = fmt::format("direction {}: ", d + 1);
    if (c.resolved) line += fmt::format("steps {:.1e} to {:.1e} cells, ", c.steps.front(), c.steps.back());
    line += fmt::format("second derivative {:.2e}", c.curvature);
    if (c.model_curvature) line += fmt::format(", Newton model {:.2e}", *c.model_curvature);
    if (c.n_points_near_faces > 0)
      line += fmt::format(
          "; kinks: {} points within the greatest step of a cell's face, {:.1f} % of the nodes held still for them",
          c.n_points_near_faces, 100 * c.held_share);
    say(line);
  }
  if (t.n_elements > 0) {
    std::string line = fmt::format("differences on {} of {} elements", t.n_differenced, t.n_elements);
    if (t.n_elements_near_faces > 0)
      line += fmt::format(", {} left out with a point on a cell's face", t.n_elements_near_faces);
    if (t.n_elements_with_kinks > 0)
      line += fmt::format(", {} with a kink and our derivative on one side of it", t.n_elements_with_kinks);
    if (t.hessian)
      line += fmt::format("; Newton model: asymmetry {:.0e}, least x.Hx / |x||Hx| {:.2g}", t.hessian->asymmetry,
                          t.hessian->least_quotient);
    say(line);
  }
  if (t.worst) {
    const WorstElement& w = *t.worst;
    say(fmt::format(
        "worst element {} (level {}, centre {:.4f}): d/d corner {} axis {}: {:.9e}, by dual numbers {:.9e}, "
        "by differences {:.9e}",
        w.element, w.level, fmt::join(w.centre, " "), w.corner, w.axis, w.analytic, w.by_jets, w.by_differences));
  }
  return text;
}

}  // namespace

bool GradientReport::passed() const {
  return std::none_of(terms.begin(), terms.end(),
                      [](const TermCheck& t) { return t.state == TermCheck::State::failed; });
}

std::string GradientReport::failed_terms() const {
  std::string names;
  for (const TermCheck& t : terms)
    if (t.state == TermCheck::State::failed) names += (names.empty() ? "" : ", ") + t.name;
  return names;
}

std::string GradientReport::faults() const {
  std::string text;
  for (const TermCheck& t : terms)
    if (t.state == TermCheck::State::failed)
      text += fmt::format("{}{} ({})", text.empty() ? "" : ", ", t.name,
                          t.faults.empty() ? "no details" : t.faults.front());
  return text;
}

std::string gradient_report_text(const GradientReport& r) {
  std::string text =
      fmt::format("{} at level {}, deformation {}: {} nodes, {} of them free, nu {:.3g}, c_vol {:.3g}\n\n", r.source,
                  r.level, r.state, r.n_nodes, r.n_free_nodes, r.nu, r.volume_weight);
  text += table(r) + "\n";
  for (const TermCheck& t : r.terms) text += remarks(t);
  text += r.passed() ? "\npassed\n" : fmt::format("\nFAILED: {}\n", r.failed_terms());
  return text;
}

}  // namespace shellmatch
