#include "matching/derivative_check/kink_free.h"

#include "base/parallel.h"

#include <algorithm>
#include <limits>

namespace shellmatch {

template <int Dim>
Vec<Dim> distance_to_cell_faces(const Octree<Dim>& grid, const Vec<Dim>& y) {
  const Vec<Dim> inside = y.cwiseMax(0.0).cwiseMin(1.0);
  const Index cell = grid.locate(inside);
  const Vec<Dim> low = grid.cell_corner(cell);
  const double side = grid.cell(cell).side();
  Vec<Dim> distance;
  for (int k = 0; k < Dim; ++k)
    distance[k] = inside[k] != y[k] ? std::abs(y[k] - inside[k]) : std::min(y[k] - low[k], low[k] + side - y[k]);
  return distance;
}

template <int Dim>
Vec<Dim> distance_to_kinks(const GeometryField<Dim>& field, const Vec<Dim>& y) {
  if (!field.is_smooth()) return distance_to_cell_faces<Dim>(field.grid(), y);
  return y.cwiseAbs().cwiseMin((y - Vec<Dim>::Ones()).cwiseAbs());
}

template <int Dim>
double least_distance_to_kinks(const CeresEvaluator<Dim>& costs, const GeometryField<Dim>& target, std::size_t e,
                               const typename CeresEvaluator<Dim>::Dofs& dofs) {
  double distance = std::numeric_limits<double>::infinity();
  for (const int q : costs.band_points(e))
    distance = std::min(distance, distance_to_kinks<Dim>(target, costs.position(dofs, q)).minCoeff());
  return distance;
}

template <int Dim>
HeldPoints hold_at_kinks(const Unknowns<Dim>& unknowns, const CeresEvaluator<Dim>& costs,
                         const GeometryField<Dim>& target, const Octree<Dim>& grid, std::span<const Vec<Dim>> phi,
                         double reach, std::vector<double>& direction) {
  const auto elements = unknowns.elements();
  std::vector<Index> unknown_of(phi.size(), no_index);
  for (std::size_t i = 0; i < unknowns.nodes().size(); ++i) unknown_of[unknowns.nodes()[i]] = static_cast<Index>(i);
  std::vector<const HangingNode<Dim>*> hanging_of(phi.size(), nullptr);
  for (const auto& h : grid.hanging_nodes()) hanging_of[h.node] = &h;

  HeldPoints held;
  std::vector<char> is_held(unknowns.nodes().size(), 0);
  const auto hold = [&](Index node) {
    const Index u = unknown_of[node];
    if (u == no_index || is_held[u]) return;
    is_held[u] = 1;
    ++held.n_nodes;
    std::fill_n(direction.begin() + static_cast<std::ptrdiff_t>(u) * Dim, Dim, 0.0);
  };

  std::vector<Vec<Dim>> nodal(phi.size());
  std::vector<int> n_passing(elements.size());
  for (bool done = false; !done;) {
    std::fill(nodal.begin(), nodal.end(), Vec<Dim>::Zero());
    unknowns.expand(direction, nodal);
    parallel_for(
        elements.size(),
        [&](std::size_t e) {
          n_passing[e] = 0;
          const std::vector<int> points = costs.band_points(e);
          if (points.empty()) return;
          const auto at = costs.dofs_of(e, phi), by = costs.dofs_of(e, nodal);
          for (const int q : points) {
            const Vec<Dim> distance = distance_to_kinks<Dim>(target, costs.position(at, q));
            n_passing[e] += (reach * costs.position(by, q).cwiseAbs().array() > distance.array()).any();
          }
        },
        64);
    done = true;
    for (std::size_t e = 0; e < elements.size(); ++e) {
      if (n_passing[e] == 0) continue;
      done = false;
      held.n_points += static_cast<std::size_t>(n_passing[e]);
      for (const Index node : elements[e].nodes) {
        hold(node);
        if (hanging_of[node] != nullptr)
          for (int p = 0; p < hanging_of[node]->n_parents; ++p) hold(hanging_of[node]->parents[p]);
      }
    }
  }
  return held;
}

SHELLMATCH_2D_3D(distance_to_cell_faces);
SHELLMATCH_2D_3D(distance_to_kinks);
SHELLMATCH_2D_3D(least_distance_to_kinks);
SHELLMATCH_2D_3D(hold_at_kinks);

}  // namespace shellmatch
