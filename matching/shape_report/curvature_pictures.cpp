#include "geometry/io/write_shape.h"
#include "matching/shape_report/curvature_report.h"
#include "matching/render/canvas/contours.h"
#include "matching/render/canvas/panel.h"
#include "matching/render/canvas/plot.h"
#include "matching/render/surfaces/surfaces.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace shellmatch {

namespace {

template <int Dim>
using Curvatures = std::vector<PrincipalCurvature<Dim>>;

template <int Dim>
const Curvatures<Dim>& expected_of(const CurvatureComparison<Dim>& c) {
  return c.formula.empty() ? c.mesh_fit : c.formula;
}

template <int Dim>
const char* expectation_name(const CurvatureComparison<Dim>& c) {
  return c.formula.empty() ? (Dim == 2 ? "fit to the vertices" : "jets of the mesh") : "formula";
}

template <int Dim>
std::vector<double> member(const Curvatures<Dim>& all, double PrincipalCurvature<Dim>::*k, double scale = 1) {
  std::vector<double> values;
  for (const auto& v : all) values.push_back(scale * (v.*k));
  return values;
}

// The quantile `share` of the absolute values; greater than 0.
double size_quantile(const std::vector<double>& values, double share) {
  std::vector<double> sizes;
  for (const double v : values)
    if (std::isfinite(v)) sizes.push_back(std::abs(v));
  if (sizes.empty()) return 1;
  std::sort(sizes.begin(), sizes.end());
  return std::max(1e-12, sizes[static_cast<std::size_t>(share * static_cast<double>(sizes.size() - 1))]);
}

std::vector<double> mean_curvature(const Curvatures<2>& all) { return member<2>(all, &PrincipalCurvature<2>::k1); }
std::vector<double> mean_curvature(const Curvatures<3>& all) {
  std::vector<double> values;
  for (const auto& v : all) values.push_back(0.5 * (v.k1 + v.k2));
  return values;
}

template <int Dim>
OriginalShape<Dim> coloured_shape(const CurvatureComparison<Dim>& c) {
  OriginalShape<Dim> shape;
  shape.vertices = c.surface.vertices;
  const auto add = [&](const std::string& name, const char* type, std::vector<double> values) {
    shape.attributes.push_back({name, type, std::move(values)});
  };
  const std::vector<double> mean = mean_curvature(c.grid);
  std::array<std::vector<double>, 3> rgb;
  const double end = size_quantile(mean, 0.95);
  for (const double h : mean) {
    const Color color = map_color(ColorMap::diverging, 0.5 + 0.5 * h / end);
    rgb[0].push_back(255 * color.r);
    rgb[1].push_back(255 * color.g);
    rgb[2].push_back(255 * color.b);
  }
  if constexpr (Dim == 3) {
    add("red", "uchar", rgb[0]);
    add("green", "uchar", rgb[1]);
    add("blue", "uchar", rgb[2]);
    add("quality", "float", mean);
  }
  const auto add_curvatures = [&](const Curvatures<Dim>& all, const std::string& suffix) {
    if (all.empty()) return;
    add(Dim == 3 ? "k1" + suffix : "curvature" + suffix, "double", member<Dim>(all, &PrincipalCurvature<Dim>::k1));
    if constexpr (Dim == 3) add("k2" + suffix, "double", member<Dim>(all, &PrincipalCurvature<Dim>::k2));
  };
  add_curvatures(c.grid, "");
  add_curvatures(c.mesh_fit, "_mesh");
  add_curvatures(c.formula, "_formula");
  if constexpr (Dim == 3)
    for (int k = 0; k < 3; ++k) {
      std::vector<double> component;
      for (const auto& v : c.grid) component.push_back(v.first[k]);
      add(std::string("d1") + "xyz"[k], "double", component);
    }
  return shape;
}

}  // namespace

void write_curvature_mesh(const CurvatureComparison<3>& c, const std::string& path) {
  OriginalShape<3> shape = coloured_shape(c);
  for (const auto& facet : c.surface.facets) shape.polygons.emplace_back(facet.begin(), facet.end());
  write_ply(path, shape);
}

void write_curvature_mesh(const CurvatureComparison<2>& c, const std::string& path) {
  OriginalShape<2> shape = coloured_shape(c);
  std::vector<Index> next(c.surface.vertices.size(), no_index);
  for (const auto& [a, b] : c.surface.facets) next[a] = b;
  for (Index v = 0; v < static_cast<Index>(next.size()); ++v) {
    std::vector<Index> ring;
    for (Index w = v; w != no_index && next[w] != no_index; w = std::exchange(next[w], no_index)) ring.push_back(w);
    if (!ring.empty()) shape.polygons.push_back(std::move(ring));
  }
  write_outline_csv(path, shape);
}

template <int Dim>
void write_curvature_scatter(const CurvatureComparison<Dim>& c, const std::string& path) {
  const Curvatures<Dim>& expected = expected_of(c);
  std::vector<double> all = member<Dim>(expected, &PrincipalCurvature<Dim>::k1, c.diagonal);
  const std::vector<double> k2 = member<Dim>(expected, &PrincipalCurvature<Dim>::k2, c.diagonal);
  all.insert(all.end(), k2.begin(), k2.end());
  const double end = 1.1 * size_quantile(all, 0.98);
  const auto shows = [&](double value) { return std::abs(value) <= end; };
  const std::size_t stride = std::max<std::size_t>(1, c.grid.size() / 4000);
  const auto points = [&](const char* name, double PrincipalCurvature<Dim>::*k) {
    Series series{.name = name, .x = {}, .y = {}, .points = true, .line = false, .point_radius = 1.6};
    for (std::size_t v = 0; v < c.grid.size(); v += stride) {
      const double x = c.diagonal * (expected[v].*k), y = c.diagonal * (c.grid[v].*k);
      if (shows(x) && shows(y)) series.x.push_back(x), series.y.push_back(y);
    }
    return series;
  };
  Plot plot{.title = fmt::format("curvatures of the grid of level {}", c.levels.back().level),
            .x_label = fmt::format("{}, times the diagonal", expectation_name(c)),
            .y_label = "grid, times the diagonal",
            .width = 820,
            .height = 700};
  plot.series.push_back(points(Dim == 3 ? "k1" : "curvature", &PrincipalCurvature<Dim>::k1));
  if (Dim == 3) plot.series.push_back(points("k2", &PrincipalCurvature<Dim>::k2));
  double low = end, high = -end;
  for (const Series& s : plot.series)
    for (const double v : s.x) {
      low = std::min(low, v);
      high = std::max(high, v);
    }
  if (low < high) plot.series.push_back({.name = "equal", .x = {low, high}, .y = {low, high}, .dashed = true});
  write_plot(plot, path);
}

template <int Dim>
void write_curvature_picture(const CurvatureComparison<Dim>& c, const std::string& title, const std::string& path) {
  constexpr int size = 440;
  const Curvatures<Dim>& expected = expected_of(c);
  const auto draw = [&](const std::vector<double>& values, const ColorBar& bar) {
    if constexpr (Dim == 3) {
      RenderSurface surface{.surface = &c.surface, .paint = Paint::scalar, .scalars = values};
      surface.scalar_min = bar.min;
      surface.scalar_max = bar.max;
      surface.color_map = bar.map;
      const Surface<3>* all[] = {&c.surface};
      return render_surfaces(std::span(&surface, 1), fit_camera(all, 1), {.width = size, .height = size, .samples = 3});
    } else {
      RenderContour contour{.contour = &c.surface, .line_width = 4};
      for (const double v : values)
        contour.vertex_colors.push_back(map_color(bar.map, (v - bar.min) / (bar.max - bar.min)));
      const Surface<2>* all[] = {&c.surface};
      return render_contours(std::span(&contour, 1), fit_frame(all), size, size);
    }
  };
  std::vector<Panel> panels;
  const auto add_row = [&](const std::string& name, double PrincipalCurvature<Dim>::*k) {
    const std::vector<double> found = member<Dim>(c.grid, k, c.diagonal), known = member<Dim>(expected, k, c.diagonal);
    std::vector<double> difference(found.size());
    for (std::size_t v = 0; v < found.size(); ++v) difference[v] = std::abs(found[v] - known[v]);
    const double end = size_quantile(known, 0.95);
    const ColorBar bar{ColorMap::diverging, -end, end, name + " times the diagonal"};
    const ColorBar error_bar{ColorMap::sequential, 0, size_quantile(difference, 0.95),
                             name + ", difference times the diagonal"};
    panels.push_back({draw(found, bar), name + ", grid", bar});
    panels.push_back({draw(known, bar), name + ", " + expectation_name(c), bar});
    panels.push_back({draw(difference, error_bar), name + ", difference", error_bar});
  };
  add_row(Dim == 3 ? "k1" : "curvature", &PrincipalCurvature<Dim>::k1);
  if (Dim == 3) add_row("k2", &PrincipalCurvature<Dim>::k2);
  write_png(compose_panels(panels, title, 3), path);
}

SHELLMATCH_2D_3D(write_curvature_scatter);
SHELLMATCH_2D_3D(write_curvature_picture);

}  // namespace shellmatch
