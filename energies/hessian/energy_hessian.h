#pragma once
/// \file
/// A positive semidefinite model of the energy's second derivative, for Newton's method.
///
/// Band terms: J^T W''_+ J at every quadrature point, with J the derivative of the term's argument by Dphi and by phi,
/// on which the template's coefficients depend, and W''_+ the positive part of the density's second derivative: the
/// Gauss-Newton model where the term is a square. Cell terms: W''_+ at the element's centre, or J^T W''_+ J
/// at every quadrature point where A is not Dphi itself. Corner terms: J^T W''_+ J on the
/// elements where they act. Terms of points: 2 w rho' B^T B, without rho''. To the model is added, where the solver
/// asks for it, a multiple of the Laplacian's matrix on single elements: it resists changes of the step within the
/// element, and no common motion of its nodes. And pairs that a step carries out of their tolerance (an active-set
/// method).

#include "energies/assembly/matching_energy.h"
#include "energies/assembly/not_finite.h"
#include "energies/sparse/element_matrices.h"
#include "energies/sparse/node_matrix.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace shellmatch {

/// An element and a factor on the Laplacian's matrix there.
struct ElementDamping {
  std::size_t element;
  double factor;
};

template <int Dim>
class EnergyHessian {
 public:
  static constexpr int n_dofs = n_corners<Dim> * Dim;

  /// energy and unknowns must outlive this object.
  EnergyHessian(const MatchingEnergy<Dim>& energy, const Unknowns<Dim>& unknowns);

  /// Computes the model at phi. \pre the energy can be evaluated there.
  /// \param damping  factor on the Laplacian's matrix by element; empty: none
  void assemble(std::span<const Vec<Dim>> phi, const TermValues& weights, std::span<const float> damping = {});

  /// The first term, and the first element of it, whose part of the model at phi is infinite or NaN in single
  /// precision; nothing where all are finite. Slow: asked only where the model is known not to be finite.
  std::optional<NotFinite<Dim>> find_not_finite(std::span<const Vec<Dim>> phi, const TermValues& weights) const;

  /// Elements on which the step d (by the unknowns) from phi, where the model was assembled, would use up the fold
  /// margin: the smallest Bernstein coefficient of det Dphi would fall below a fifth of what it is, and below 0.2. With
  /// each the factor that makes the Laplacian's matrix as stiff as the element's own. None where no term forbids folds.
  std::vector<ElementDamping> elements_beyond_margin(std::span<const Vec<Dim>> phi, std::span<const double> d);

  /// Adds multiples of the Laplacian's matrices to the model.
  void add_damping(std::span<const ElementDamping> more);

  /// Adds the pairs that rest within their tolerance at phi, where the model was assembled with these weights, and that
  /// the step d (by the unknowns) carries beyond it: to the model their stiffness, and to the energy's gradient at phi,
  /// which becomes that of the model, their pull towards the end of their tolerance (ActivatedPair). Each pair once.
  /// Returns how many were added.
  std::size_t extend(std::span<const Vec<Dim>> phi, std::span<const double> d, const TermValues& weights,
                     std::span<double> gradient);

  /// Brings the step d (by the unknowns) in each of these elements, one after the other, nearer to a common motion of
  /// all its unknown nodes: from their mean, d keeps this share. Where nodes of the element are fixed, from zero.
  void contract_step(std::span<const ElementDamping> elements, double share, std::span<double> d) const;

  /// y = H x by the unknowns.
  void apply(std::span<const double> x, std::span<double> y) const;

  /// z = D^{-1} r with the blocks of one node each on H's diagonal.
  void precondition(std::span<const double> r, std::span<double> z) const;

 private:
  /// Fold margin of eight elements.
  struct Margin {
    autodiff::Pack least_determinant;  ///< smallest Bernstein coefficient of det Dphi
    autodiff::Pack largest_entry;      ///< of Dphi, in size
  };

  // The matrices of the elements of one block: the first writes, the others add.
  void set_cell_terms(const Chunk& cells, std::span<const Vec<Dim>> phi, const TermValues& weights,
                      ElementMatrices<Dim>& matrices) const;
  // Of terms that read more than Dphi, at all their quadrature points.
  void add_points_of(const CellCode<Dim>& code, std::size_t t, const Chunk& cells, std::span<const Vec<Dim>> phi,
                     double weight, ElementMatrices<Dim>& matrices) const;
  void add_corner_terms(const Chunk& cells, std::span<const Vec<Dim>> phi, const TermValues& weights,
                        ElementMatrices<Dim>& matrices) const;
  template <class Variables>
  void add_band_terms(const Chunk& cells, std::span<const Vec<Dim>> phi, const TermValues& weights,
                      ElementMatrices<Dim>& matrices) const;
  void add_point_terms(const Chunk& cells, std::span<const Vec<Dim>> phi, const TermValues& weights,
                       ElementMatrices<Dim>& matrices) const;
  void add_damping(const Chunk& cells, std::span<const float> damping, ElementMatrices<Dim>& matrices) const;
  std::optional<Vec<Dim>> model_point(std::size_t term, std::size_t e, std::span<const Vec<Dim>> phi) const;
  void measure_margins(const Chunk& cells, std::span<const Vec<Dim>> phi);
  void invert_block(std::size_t unknown);
  void invert_blocks_of(std::size_t element);  // of all unknown nodes on which the element depends

  const MatchingEnergy<Dim>* energy_;
  const Unknowns<Dim>* unknowns_;
  std::optional<NodeMatrix<Dim>> sum_;  ///< of the elements' matrices; its pattern is found when it is first wanted
  std::vector<float> traces_;           ///< of the elements' matrices without damping
  bool folds_cost_ = false;             ///< is there a term that forbids them?
  std::vector<Margin> margins_;         ///< by eight elements, at the phi of the last assemble()
  /// Of each unknown node, in single precision as the matrix.
  std::vector<Eigen::Matrix<float, Dim, Dim>> inverse_blocks_;
  std::vector<std::vector<std::uint8_t>> is_active_;  ///< by term and pair: was it added by extend()?
};

}  // namespace shellmatch
