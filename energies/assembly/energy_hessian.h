#pragma once
/// \file
/// A positive semidefinite model of the energy's second derivative, for Newton's method.
///
/// Match: Gauss-Newton. Membrane and bending: J^T W'' J with the second derivative of W made positive
/// semidefinite at every quadrature point in closed form, in the tangent frames of both surfaces (there W is
/// a function of a matrix of one row and column less), and J the first derivative of its argument by Dphi and
/// by phi, on which n2 and the template's curvature depend. Volume: the second derivative at the element's
/// centre, by principal stretches. Barrier: Gauss-Newton.

#include "energies/sparse/element_matrices.h"
#include "energies/assembly/matching_energy.h"
#include "energies/sparse/node_matrix.h"

#include <optional>
#include <span>
#include <vector>

namespace shellmatch {

template <int Dim>
class EnergyHessian {
 public:
  static constexpr int n_dofs = n_corners<Dim> * Dim;

  /// energy and unknowns must outlive this object.
  EnergyHessian(const MatchingEnergy<Dim>& energy, const Unknowns<Dim>& unknowns,
                const GeometryField<Dim>& target, const EnergyOptions& options);

  /// Computes the model at phi. \pre the energy can be evaluated there.
  void assemble(std::span<const Vec<Dim>> phi, const TermValues& weights);

  /// Where the step d (nodal) from phi would fold a cell, or nearly so, the model knows nothing of it: adds
  /// to such cells' matrices a multiple of the Laplacian's, which resists every change of the step within the
  /// cell but none of it as a whole: Levenberg's and Marquardt's remedy, cell by cell. The multiples are kept
  /// over the steps, where they fall unless they are called for again. False where no cell is in want of it.
  bool restrain(std::span<const Vec<Dim>> phi, std::span<const double> d);

  /// y = H x by the unknowns.
  void apply(std::span<const double> x, std::span<double> y) const;

  /// z = D^{-1} r with the blocks of one node each on H's diagonal.
  void precondition(std::span<const double> r, std::span<double> z) const;

 private:
  // The matrices of a block's elements: the first writes, the others add.
  void set_volume(const Chunk& cells, std::span<const Vec<Dim>> phi, double weight, ElementMatrices<Dim>& matrices) const;
  void add_barrier(const Chunk& cells, std::span<const Vec<Dim>> phi, double weight, ElementMatrices<Dim>& matrices) const;
  void add_band(const Chunk& cells, std::span<const Vec<Dim>> phi, const TermValues& weights,
                ElementMatrices<Dim>& matrices) const;
  void add_kept_restraint(const Chunk& cells, ElementMatrices<Dim>& matrices);
  void measure_room(const Chunk& cells, std::span<const Vec<Dim>> phi);
  void invert_block(std::size_t unknown);

  const MatchingEnergy<Dim>* energy_;
  const Unknowns<Dim>* unknowns_;
  const GeometryField<Dim>* target_;
  EnergyOptions options_;
  std::optional<NodeMatrix<Dim>> sum_;  ///< of the elements' matrices; its pattern is found when it is first wanted
  std::vector<float> traces_;           ///< of the elements' matrices, kept restraint aside
  bool folds_cost_ = false;             ///< is there a term that forbids them?
  std::vector<float> restraint_;        ///< factor on the Laplacian's matrix, by element
  struct Room {
    autodiff::Pack least_determinant, largest_entry;
  };
  std::vector<Room> room_;                ///< eight elements each, at the phi of the last assemble()
  std::vector<Mat<Dim>> inverse_blocks_;  ///< of each unknown node
  std::vector<Vec<Dim>> nodal_;           ///< scratch of restrain()
};

}  // namespace shellmatch
