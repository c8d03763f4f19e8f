#pragma once
/// \file
/// A term as the assembly calls it: its compiled code behind function pointers, eight quadrature points or elements at
/// a time. energies/compiled/compile_term.h makes it from the term's type.

#include "energies/autodiff/pack.h"
#include "energies/cost/cost_function.h"
#include "energies/cost/element_fields.h"
#include "energies/densities/pack_eigen.h"
#include "energies/densities/tangent_frames.h"
#include "energies/elements/element_batch.h"
#include "energies/elements/sum_factorised_evaluator.h"
#include "energies/fields/coefficients.h"
#include "energies/pairs/pair_term.h"
#include "energies/terms/term.h"

#include <array>
#include <span>
#include <variant>

namespace shellmatch {

/// What the band terms read at eight quadrature points and what they give back, as flat arrays of packs: the inputs of
/// compiled code (energies/autodiff/compiled.h).
template <int Dim>
struct PointArrays {
  static constexpr int n_target = TargetPoint<Dim, double>::size;
  static constexpr int n_reference = ReferencePoint<Dim, double>::size;
  static constexpr int n_without_phi = n_target + Dim * Dim, n_active = n_without_phi + Dim;
  static constexpr int n_passive = n_reference + 2;

  std::array<autodiff::Pack, n_active> active;    ///< d2, n2, root; Dphi by rows; phi where a term reads it
  std::array<autodiff::Pack, n_passive> passive;  ///< d1, n1, r1; lambda, mu
  std::array<autodiff::Pack, n_active> adjoint;   ///< derivative by the active inputs, weighted
  std::array<std::array<autodiff::Pack, n_target>, Dim> derivative;  ///< of d2, n2, root by each coordinate of phi
  const autodiff::Pack* own_fields = nullptr;                        ///< of the term that is evaluated
};

/// What Newton's model of the band reads at eight points. The model is a matrix by variables of the point: by
/// X_ij = t2_i . Dphi t1_j, then by phi (tangent variables); or by the entries of Dphi in row order, then by phi (all
/// variables).
template <int Dim>
struct BandModelPoint {
  static constexpr int n_tangent = (Dim - 1) * (Dim - 1) + Dim, n_all = Dim * Dim + Dim;
  const PointArrays<Dim>& arrays;  ///< with the derivatives by phi
  const autodiff::Pack& weight;    ///< 0 in lanes that do not count
  const TangentBasis<Dim>&t1, &t2;
};

/// Of a term on the band. `own` are the values of the term's own options.
template <int Dim>
struct BandCode {
  using Pack = autodiff::Pack;
  /// Values, times seed; with the gradient, adds the derivative times seed to `adjoint`.
  Pack (*value)(PointArrays<Dim>& p, const Pack& seed, const double* own);
  Pack (*gradient)(PointArrays<Dim>& p, const Pack& seed, const double* own);
  /// Adds weight J^T W''_+ J to the lower triangle of h, with J the derivative of the argument and W''_+ the positive
  /// part of the density's second derivative. add_in_tangent is null where the tangent variables do not determine the
  /// term's derivative.
  void (*add_in_tangent)(const BandModelPoint<Dim>& at, double weight, const double* own,
                         SquarePack<BandModelPoint<Dim>::n_tangent>& h);
  void (*add_in_all)(const BandModelPoint<Dim>& at, double weight, const double* own,
                     SquarePack<BandModelPoint<Dim>::n_all>& h);
  bool reads_target;  ///< anything of the template
  bool reads_phi;     ///< the position itself
  bool reads_dphi;
  bool reads_curvature;  ///< r1 or root
  bool reads_shape_operators;
};

/// Eight elements as the cell terms read them, and what is computed of them.
template <int Dim>
struct CellBatch {
  ElementBatch<Dim> elements;
  SumFactorisedEvaluator<Dim, false> evaluator;
  std::span<const Element<Dim>> all;  ///< all elements, and the numbers of these eight among them
  std::array<std::size_t, autodiff::pack_size> number;
  const UserFields<Dim>* own_fields = nullptr;  ///< of the term that is evaluated
  explicit CellBatch(const ShapeTable<Dim>& shape) : evaluator(shape) {}
};

/// Weighted values of a term on each of the eight; with the gradient, adds it to that of the elements.
/// \param measure  side^Dim times the term's weight; 0 in lanes that do not count
template <int Dim>
using CellKernel = autodiff::Pack (*)(CellBatch<Dim>& batch, const ShapeTable<Dim>& shape,
                                      const Material<double>& material, const autodiff::Pack& measure);

/// Symmetric second derivative by the degrees of freedom of an element.
template <int Dim>
using ElementHessian = Eigen::Matrix<double, n_corners<Dim> * Dim, n_corners<Dim> * Dim>;

/// Of a term on cells. One of the last two is null.
template <int Dim>
struct CellCode {
  CellKernel<Dim> value, gradient;
  bool reads_dphi;
  /// Where the argument is Dphi itself: positive part of the second derivative by its entries.
  SquarePack<Dim * Dim> (*hessian)(const SmallMat<autodiff::Pack, Dim>& dphi, const Material<double>& material);
  /// Of others: adds weight J^T W''_+ J of one element, over all its quadrature points.
  void (*add_hessian)(const ElementFields<Dim>& element, const double* dofs, double weight,
                      const Material<double>& material, ElementHessian<Dim>& h);
};

/// Of a term of the corners' positions.
template <int Dim>
struct CornerCode {
  CellKernel<Dim> value, gradient;
  autodiff::Pack (*may_act)(const ElementBatch<Dim>& batch, const Material<double>& material);
  /// Adds weight J^T W''_+ J of one element.
  void (*add_hessian)(const double* dofs, double side, double weight, const Material<double>& material,
                      ElementHessian<Dim>& h);
};

/// Of a term of point pairs.
template <int Dim>
struct PointCode {
  PairTerm<Dim> pairs;
};

/// Those of points have neither `cost` nor `modulus`.
template <int Dim>
struct CompiledTerm {
  TermInfo info;
  std::span<const TermOption> own;
  int n_own_fields = 0;  ///< components of its own fields together
  std::variant<BandCode<Dim>, CellCode<Dim>, CornerCode<Dim>, PointCode<Dim>> code;
  /// The term on one element in Ceres' terms, without the compiled code (energies/cost/element_cost.h).
  ElementCostFunction (*cost)(const ElementFields<Dim>&, double weight, const Material<double>&) = nullptr;
  /// The same as residuals; null where W is no square.
  ElementCostFunction (*residuals)(const ElementFields<Dim>&, double weight, const Material<double>&) = nullptr;
  /// Largest second derivative of the density where it rests; of a corner term, its scale on a cell of side 1.
  double (*modulus)(const Material<double>&) = nullptr;
};

}  // namespace shellmatch
