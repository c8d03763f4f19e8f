#pragma once
/// \file
/// Bytes that one evaluation has to move between memory and the processor if nothing stays in the caches from
/// one pass over an array to the next: every array that a pass touches once, read or written. What caches
/// cannot keep within a pass comes on top, so these are lower bounds.

#include "energies/sparse/node_matrix.h"
#include "matching/level/level_energy.h"

#include <vector>

namespace shellmatch::bench {

struct Traffic {
  double value, gradient, band_gradient, newton_model, newton_product;  ///< bytes
  double n_blocks;  ///< of the matrix by unknowns that are stored: on and above the diagonal
};

inline Traffic traffic_of(const LevelEnergy<3>& level) {
  const auto& unknowns = level.unknowns;
  const auto& band = level.energy.band();
  const double n_nodes = level.grid.n_nodes(), n_free = static_cast<double>(unknowns.nodes().size());
  const double n_cells = static_cast<double>(unknowns.elements().size());
  const double n_band = static_cast<double>(band.n_elements());

  std::vector<char> in_band(level.grid.n_nodes(), 0);
  for (const auto& batch : band.batches())
    for (const Index e : batch.element)
      for (const Index node : unknowns.elements()[e].nodes) in_band[node] = 1;
  double n_band_nodes = 0;
  for (const char c : in_band) n_band_nodes += c;

  const NodeMatrix<3> matrix(unknowns);
  const auto n_blocks = static_cast<double>(matrix.n_blocks());
  const auto n_offsets = static_cast<double>(matrix.n_element_blocks());

  // Local unknowns of all cell blocks: an unknown of several blocks is read and written once for each.
  const auto& cell_blocks = level.energy.cell_blocks();
  double n_local = 0;
  for (std::size_t block = 0; block < cell_blocks.size(); ++block)
    n_local += static_cast<double>(cell_blocks.local_unknowns(block).size());

  constexpr double vec = sizeof(Vec<3>);
  const double all_cells = n_cells * sizeof(Element<3>) + n_nodes * vec;  // elements and positions, in one pass
  const double points =
      static_cast<double>(band.batches().size() * level.energy.shape().points.size()) * sizeof(Band<3>::Point);
  // The template is looked up in about as many cells as the band has; as splines, each has a coefficient (a
  // row of values), and eight have one list of the numbers of their neighbours'.
  const bool smooth = level.geometry.target.is_smooth();
  const double rows = smooth ? n_band : n_band_nodes;
  const double look_up = n_band * (smooth ? sizeof(SplineSpace<3>::Local) / 8.0 : Octree<3>::bytes_per_cell()) +
                         rows * static_cast<double>(sizeof(GeometryField<3>::Values));
  const double band_pass = n_band * sizeof(Element<3>) + n_band_nodes * vec + points + look_up;
  const double n_accesses = 2 * n_local - n_free;  // each block writes its unknowns, all but the first read them too
  const double sum = n_local * sizeof(CellBlocks<3>::LocalUnknown) + n_cells * sizeof(CellBlocks<3>::LocalIndices) +
                     static_cast<double>(cell_blocks.n_local_entries()) * sizeof(CellBlocks<3>::LocalEntry);
  const double finite = n_nodes * vec;
  const double values = NodeMatrix<3>::block_size * sizeof(float), block = values + sizeof(Index);

  Traffic t{};
  t.n_blocks = n_blocks;
  t.value = finite + all_cells + band_pass;
  t.gradient = t.value + sum + n_accesses * vec;
  t.band_gradient = finite + band_pass + sum + n_accesses * vec;
  t.newton_model = all_cells + n_cells * (2 * sizeof(double) + sizeof(float)) + band_pass + sum + n_offsets +
                   n_blocks * n_accesses / n_free * values + n_free * 3 * 3 * (sizeof(float) + sizeof(double));
  t.newton_product = n_blocks * block + n_free * (3 * vec + sizeof(std::size_t));
  return t;
}

}  // namespace shellmatch::bench
