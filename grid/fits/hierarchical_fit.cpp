#include "grid/fits/hierarchical_fit.h"

#include "base/parallel.h"
#include "grid/fits/lattice_fit.h"
#include "grid/octree/prolongation.h"

namespace shellmatch {

template <int Dim>
void HierarchicalFit<Dim>::update(const Octree<Dim>& grid, const std::vector<double>& nodal,
                                  const CoefficientOptions& options) {
  const LatticeFit<Dim> lattice(grid, static_cast<std::size_t>(n_neighbours<Dim>(options)), options.fit_weight);
  const auto put = [&](Index node, const SymmetricComponents<Dim>& hessian) {
    values_[node] = Components::Map(hessian.data());
  };
  if (values_.empty() || !lattice.is_possible()) {
    values_.resize(static_cast<std::size_t>(grid.n_nodes()), Components::Zero());
    const auto free = grid.free_nodes();
    const auto fitted = fit_hessians<Dim>(grid, nodal, options, free);
    for (std::size_t i = 0; i < free.size(); ++i) put(free[i], fitted[i]);
    return;
  }
  prolongate(grid, static_cast<Index>(values_.size()), values_);
  parallel_chunks(values_.size(), 1024, [&](const Chunk& chunk) {
    std::vector<Index> neighbours;
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const auto node = static_cast<Index>(i);
      const double side = lattice.find_neighbours(node, neighbours);
      if (side == grid.finest_side()) put(node, lattice.hessian(nodal, node, side, neighbours));
    }
  });
}

template class HierarchicalFit<2>;
template class HierarchicalFit<3>;

}  // namespace shellmatch
