#include "matching/shape_report/curvature_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace shellmatch {

namespace {

// The median of the absolute values of a quantity that is known at some vertices.
template <class Values>
double median_size(const Values& values, const auto& member) {
  std::vector<double> sizes;
  for (const auto& v : values)
    if (std::isfinite(member(v))) sizes.push_back(std::abs(member(v)));
  if (sizes.empty()) return 0;
  std::nth_element(sizes.begin(), sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2), sizes.end());
  return sizes[sizes.size() / 2];
}

std::string columns(const CurvatureErrors& e, int dimension) {
  std::string row = fmt::format("{:>10.3g}{:>10.3g}", e.k1.median, e.k1.p95);
  if (dimension == 3)
    row += fmt::format(
        "{:>10.3g}{:>10.3g}{:>10.3g}{:>10.3g}{:>6.0f} %", e.k2.median, e.k2.p95, e.direction.median, e.direction.p95,
        100.0 * static_cast<double>(e.n_directions) / static_cast<double>(std::max<std::size_t>(1, e.n_vertices)));
  return row;
}

std::string order(double before, double after) {
  const double value = std::log2(before / after);
  return std::isfinite(value) ? fmt::format("{:>9.2f}", value) : fmt::format("{:>9}", "");
}

template <int Dim>
std::string block(const CurvatureComparison<Dim>& c, const char* title, const auto& errors_of) {
  std::string text =
      fmt::format("\n{}\n  {:<7}{:>12}{:>11}{:>10}{:>10}", title, "level", "h/diagonal", "nodes", "k1 median", "95 %");
  if (Dim == 3) text += fmt::format("{:>10}{:>10}{:>10}{:>10}{:>8}", "k2 median", "95 %", "degrees", "95 %", "of all");
  text += fmt::format("{:>9}{}\n", "order k1", Dim == 3 ? "       k2" : "");
  const CurvatureErrors* before = nullptr;
  for (const CurvatureLevel& l : c.levels) {
    const CurvatureErrors& e = *errors_of(l);
    text += fmt::format("  {:<7}{:>12.3g}{:>11}{}", l.level, l.side, l.n_nodes, columns(e, Dim));
    if (before) text += order(before->k1.median, e.k1.median);
    if (before && Dim == 3) text += order(before->k2.median, e.k2.median);
    text += "\n";
    before = &e;
  }
  return text;
}

}  // namespace

template <int Dim>
std::string curvature_text(const CurvatureComparison<Dim>& c, const CurvatureSubject& subject) {
  const std::string fit = Dim == 2
                              ? fmt::format("parabolas through {} vertices", 2 * subject.fit.n_rings + 1)
                              : fmt::format("jets of degree {} over {} rings", subject.fit.degree, subject.fit.n_rings);
  std::string text =
      fmt::format("{}: {} vertices, diagonal {:.6g}\n", subject.source, c.surface.vertices.size(), c.diagonal);
  text += fmt::format("median |k1| {:.3g}", c.diagonal * median_size(c.mesh_fit, [](const auto& v) { return v.k1; }));
  if (Dim == 3)
    text += fmt::format(", |k2| {:.3g}", c.diagonal * median_size(c.mesh_fit, [](const auto& v) { return v.k2; }));
  text += fmt::format(" by {}; curvatures and their errors in units of 1/diagonal\n", fit);
  text += block(c, "grid against the fit to the mesh", [](const CurvatureLevel& l) { return &l.to_mesh_fit; });
  if (!c.mesh_fit_to_formula) return text;
  text += block(c, "grid against the formula", [](const CurvatureLevel& l) { return &*l.to_formula; });
  text += block(c, "grid with the distance by its formula against the formula",
                [](const CurvatureLevel& l) { return &*l.formula_to_formula; });
  text += fmt::format("\nfit to the mesh against the formula\n{:>32}{}\n", "", columns(*c.mesh_fit_to_formula, Dim));
  return text;
}

SHELLMATCH_2D_3D(curvature_text);

}  // namespace shellmatch
