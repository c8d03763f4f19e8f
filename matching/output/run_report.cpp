#include "matching/output/run_report.h"

#include "base/error.h"
#include "base/parallel.h"
#include "geometry/distance/distortion.h"
#include "geometry/distance/surface_distance.h"
#include "grid/fields/interpolation.h"

#include <Eigen/Geometry>

#include <cmath>
#include <fstream>
#include <sstream>

namespace shellmatch {

template <int Dim>
Surface<Dim> subdivided(const Surface<Dim>& surface, double length) {
  if constexpr (Dim == 3) {
    (void)length;
    return surface;
  } else {
    Surface<2> fine{surface.vertices, {}};
    for (std::size_t f = 0; f < surface.facets.size(); ++f) {
      const auto [a, b] = surface.facets[f];
      const Vec<2> from = surface.vertices[a], edge = surface.vertices[b] - from;
      const int pieces = std::max(1, static_cast<int>(std::ceil(edge.norm() / length)));
      Index last = a;
      for (int k = 1; k < pieces; ++k) {
        fine.vertices.push_back(from + edge * (static_cast<double>(k) / pieces));
        fine.facets.push_back({last, static_cast<Index>(fine.vertices.size()) - 1});
        last = fine.facets.back()[1];
      }
      fine.facets.push_back({last, b});
    }
    return fine;
  }
}

template <int Dim>
Surface<Dim> deformed_surface(const Surface<Dim>& reference, const Octree<Dim>& grid, const std::vector<Vec<Dim>>& phi) {
  Surface<Dim> deformed = reference;
  parallel_for(deformed.vertices.size(), [&](std::size_t i) {
    deformed.vertices[i] = evaluate(grid, phi, reference.vertices[i]);
  });
  return deformed;
}

template <int Dim>
TwoSidedDistance two_sided_distance(const Surface<Dim>& deformed, const SignedDistance<Dim>& template_distance) {
  const auto quality = match_quality(deformed, template_distance);
  const auto one_sided = [](const DistanceStatistics& s) { return OneSidedDistance{s.mean, s.p95, s.max}; };
  return {one_sided(quality.deformed_to_template), one_sided(quality.template_to_deformed)};
}

LevelSummary level_summary(const LevelResult& r, const IterationRecord& last) {
  const auto named = [](const TermValues& values) {
    NamedValues list;
    for (std::size_t t = 0; t < values.size(); ++t) list.emplace_back(term_names()[t], values[t]);
    list.emplace_back("total", values.sum());
    return list;
  };
  LevelSummary s;
  s.level = r.start.level;
  s.sigma = r.start.sigma;
  s.nu = r.start.nu;
  s.volume_weight = r.start.volume_weight;
  s.n_substeps = r.start.n_substeps;
  s.n_nodes = r.start.n_nodes;
  s.n_free_nodes = r.start.n_free_nodes;
  s.n_cells = r.start.n_cells;
  s.n_band_cells = r.n_band_cells;
  s.energy_minimised = named(r.minimised);
  s.energy_reported = named(r.reported);
  s.iterations = r.iterations;
  s.value_evaluations = r.value_evaluations;
  s.gradient_evaluations = r.gradient_evaluations;
  s.gradient_norm = last.gradient_norm;
  s.l2_gradient_norm = last.l2_gradient_norm;
  s.solver = r.last.solver;
  s.fallbacks = r.fallbacks;
  s.stop_reason = enum_name(r.last.reason);
  s.stop_message = r.last.message;
  s.folds = r.folds;
  s.band = r.band;
  return s;
}

template <int Dim>
void add_distortion(MatchSummary& summary, const Surface<Dim>& reference, const Surface<Dim>& deformed,
                    const SignedDistance<Dim>& template_distance) {
  const auto weighted = [&](const std::vector<double>& values) {
    DistortionSummary d{0, std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    double total = 0;
    for (std::size_t f = 0; f < values.size(); ++f) {
      if (!std::isfinite(values[f])) continue;
      const double w = facet_measure(reference, static_cast<Index>(f));
      d.mean += w * values[f];
      total += w;
      d.min = std::min(d.min, values[f]);
      d.max = std::max(d.max, values[f]);
    }
    d.mean /= total;
    return d;
  };
  summary.area_distortion = weighted(facet_measure_ratios(reference, deformed));
  if constexpr (Dim == 3) {
    // The largest change of an angle under a linear map with stretches s1 >= s2: 2 atan(sqrt(s1/s2)) - 90 degrees.
    std::vector<double> degrees = angle_distortions(reference, deformed);
    for (double& a : degrees) a = (2 * std::atan(std::sqrt(a)) - std::acos(0.0)) * 90 / std::acos(0.0);
    summary.angle_distortion = weighted(degrees);
  }
  summary.n_flipped_facets = count_facing_away(deformed, template_distance);
}

template <int Dim>
Correspondence<Dim> read_correspondence(const std::string& path, std::size_t n_vertices) {
  std::ifstream in(path);
  if (!in) throw_input_error("{}: cannot be read; input.correspondence expects a file with lines 'index x y z'", path);
  Correspondence<Dim> list;
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    std::istringstream words(line.substr(0, line.find('#')));
    long index = 0;
    if (!(words >> std::ws) || words.eof()) continue;
    Vec<Dim> x;
    bool good = static_cast<bool>(words >> index);
    for (int k = 0; k < Dim; ++k) good = static_cast<bool>(words >> x[k]) && good;
    if (!good || !x.allFinite())
      throw_input_error("{}:{}: expected the index of a vertex and {} finite coordinates, found '{}'", path, number, Dim, line);
    if (index < 0 || static_cast<std::size_t>(index) >= n_vertices)
      throw_input_error("{}:{}: there is no vertex {}; the reference has {}, counted from 0", path, number, index, n_vertices);
    list.emplace_back(static_cast<Index>(index), x);
  }
  if (list.empty()) throw_input_error("{}: holds no correspondence; expected lines 'index x y z'", path);
  return list;
}

template <int Dim>
double correspondence_error(const Correspondence<Dim>& truth, const std::vector<Vec<Dim>>& vertices) {
  double sum = 0;
  for (const auto& [i, x] : truth) sum += (vertices[i] - x).norm();
  return sum / static_cast<double>(truth.size());
}

namespace {

/// Area that a polygon encloses, or the length of an edge of a ring.
double polygon_measure(const std::vector<Vec<3>>& x, const std::vector<Index>& polygon) {
  Vec<3> area = Vec<3>::Zero();
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
    area += 0.5 * (x[polygon[k]] - x[polygon[0]]).cross(x[polygon[k + 1]] - x[polygon[0]]);
  return area.norm();
}

/// Measures of what surrounds each vertex.
template <int Dim>
std::vector<double> vertex_measures(const OriginalShape<Dim>& shape) {
  std::vector<double> sum(shape.vertices.size(), 0.0);
  for (const auto& polygon : shape.polygons) {
    if constexpr (Dim == 3) {
      const double area = polygon_measure(shape.vertices, polygon);
      for (const Index v : polygon) sum[v] += area;
    } else {
      for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Index a = polygon[k], b = polygon[(k + 1) % polygon.size()];
        const double length = (shape.vertices[a] - shape.vertices[b]).norm();
        sum[a] += length;
        sum[b] += length;
      }
    }
  }
  return sum;
}

}  // namespace

template <int Dim>
OriginalShape<Dim> deformed_original(const OriginalShape<Dim>& reference, const Deformation<Dim>& deformation,
                                     const SignedDistance<Dim>& template_distance) {
  OriginalShape<Dim> moved = reference;
  std::vector<double> distance(reference.vertices.size());
  parallel_for(distance.size(), [&](std::size_t i) {
    const Vec<Dim> y = deformation(deformation.placement(reference.vertices[i]));
    moved.vertices[i] = deformation.placement.inverse(y);
    distance[i] = std::abs(template_distance(y)) / deformation.placement.scale;
  });
  const std::vector<double> before = vertex_measures(reference), after = vertex_measures(moved);
  std::vector<double> ratio(before.size());
  for (std::size_t i = 0; i < ratio.size(); ++i) ratio[i] = before[i] > 0 ? after[i] / before[i] : 1.0;
  moved.attributes.push_back({"distance_to_template", "float", std::move(distance)});
  moved.attributes.push_back({Dim == 3 ? "area_ratio" : "length_ratio", "float", std::move(ratio)});
  return moved;
}

template <int Dim>
std::vector<NodalField> nodal_fields(const CoefficientFields<Dim>& reference, const CoefficientFields<Dim>& target,
                                     const ExperimentOptions& options) {
  const auto flat = [](const auto& values, int n) {
    std::vector<double> list;
    list.reserve(values.size() * static_cast<std::size_t>(n));
    for (const auto& v : values)
      for (int k = 0; k < n; ++k) list.push_back(v[k]);
    return list;
  };
  constexpr int n_sym = n_symmetric<Dim>;
  const bool operators = reads_shape_operators(options.energy);
  const char* first = operators ? "S1" : options.coefficients.invert_at_point ? "root_C1" : "inverse_root_C1";
  return {{"d1", 1, reference.distance},
          {"d2", 1, target.distance},
          {"n1", Dim, flat(reference.normal, Dim)},
          {"n2", Dim, flat(target.normal, Dim)},
          {first, n_sym, flat(reference.root, n_sym)},
          {operators ? "S2" : "root_C2", n_sym, flat(target.root, n_sym)}};
}

template <int Dim>
std::vector<CellField> cell_fields(const Octree<Dim>& grid, const std::vector<Vec<Dim>>& phi,
                                   const std::vector<double>& distance1, double sigma) {
  const auto leaves = grid.leaves();
  CellField band{"in_band", std::vector<double>(leaves.size())};
  CellField determinant{"min_determinant", std::vector<double>(leaves.size())};
  std::vector<Element<Dim>> elements(leaves.size());
  parallel_for(leaves.size(), [&](std::size_t i) {
    const auto& cell = grid.cell(leaves[i]);
    double low = distance1[cell.nodes[0]], high = low;
    for (const Index n : cell.nodes) {
      low = std::min(low, distance1[n]);
      high = std::max(high, distance1[n]);
    }
    band.values[i] = low < sigma && high > -sigma;
    elements[i] = {cell.nodes, cell.side()};
  });
  const auto bounds = determinant_bounds<Dim>(elements, phi);
  for (std::size_t i = 0; i < bounds.size(); ++i) determinant.values[i] = bounds[i].bound;
  return {std::move(band), std::move(determinant)};
}

#define SHELLMATCH_INSTANTIATE(Dim)                                                                                   \
  template Surface<Dim> subdivided<Dim>(const Surface<Dim>&, double);                                                 \
  template Surface<Dim> deformed_surface<Dim>(const Surface<Dim>&, const Octree<Dim>&, const std::vector<Vec<Dim>>&); \
  template TwoSidedDistance two_sided_distance<Dim>(const Surface<Dim>&, const SignedDistance<Dim>&);                 \
  template void add_distortion<Dim>(MatchSummary&, const Surface<Dim>&, const Surface<Dim>&,                          \
                                    const SignedDistance<Dim>&);                                                      \
  template Correspondence<Dim> read_correspondence<Dim>(const std::string&, std::size_t);                             \
  template double correspondence_error<Dim>(const Correspondence<Dim>&, const std::vector<Vec<Dim>>&);                \
  template OriginalShape<Dim> deformed_original<Dim>(const OriginalShape<Dim>&, const Deformation<Dim>&,              \
                                                     const SignedDistance<Dim>&);                                     \
  template std::vector<NodalField> nodal_fields<Dim>(const CoefficientFields<Dim>&, const CoefficientFields<Dim>&,    \
                                                     const ExperimentOptions&);                                       \
  template std::vector<CellField> cell_fields<Dim>(const Octree<Dim>&, const std::vector<Vec<Dim>>&,                  \
                                                   const std::vector<double>&, double)
SHELLMATCH_INSTANTIATE(2);
SHELLMATCH_INSTANTIATE(3);

}  // namespace shellmatch
