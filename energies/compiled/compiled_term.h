#pragma once
/// \file
/// A term as the assembly calls it: its compiled code behind function pointers, eight quadrature points or elements at a
/// time. energies/compiled/compile_term.h makes it from the term's type.

#include "energies/cost/cost_function.h"
#include "energies/cost/element_fields.h"
#include "energies/compiled/point_arrays.h"
#include "energies/densities/square_pack.h"
#include "energies/densities/tangent_frames.h"
#include "energies/elements/element_batch.h"
#include "energies/elements/sum_factorised_evaluator.h"
#include "energies/terms/term.h"

#include <span>
#include <variant>

namespace shellmatch {

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
  bool reads_target;     ///< anything of the template
  bool reads_dphi;
  bool reads_curvature;  ///< r1 or root
  bool reads_shape_operators;
};

/// Eight elements as the cell terms read them, and what is computed of them.
template <int Dim>
struct CellBatch {
  ElementBatch<Dim> elements;
  SumFactorisedEvaluator<Dim, false> evaluator;
  explicit CellBatch(const ShapeTable<Dim>& shape) : evaluator(shape) {}
};

/// Weighted values of a term on each of the eight; with the gradient, adds it to that of the elements.
/// \param measure  side^Dim times the term's weight; 0 in lanes that do not count
template <int Dim>
using CellKernel = autodiff::Pack (*)(CellBatch<Dim>& batch, const ShapeTable<Dim>& shape, const Material<double>& material,
                                      const autodiff::Pack& measure);

/// Of a term on cells.
template <int Dim>
struct CellCode {
  CellKernel<Dim> value, gradient;
  /// Positive part of the second derivative by the entries of Dphi.
  SquarePack<Dim * Dim> (*hessian)(const SmallMat<autodiff::Pack, Dim>& dphi, const Material<double>& material);
};

/// Symmetric second derivative by the degrees of freedom of an element.
template <int Dim>
using ElementHessian = Eigen::Matrix<double, n_corners<Dim> * Dim, n_corners<Dim> * Dim>;

/// Of a term of the corners' positions.
template <int Dim>
struct CornerCode {
  CellKernel<Dim> value, gradient;
  autodiff::Pack (*may_act)(const ElementBatch<Dim>& batch, const Material<double>& material);
  /// Adds weight J^T W''_+ J of one element.
  void (*add_hessian)(const double* dofs, double side, double weight, const Material<double>& material,
                      ElementHessian<Dim>& h);
};

template <int Dim>
struct CompiledTerm {
  TermInfo info;
  std::span<const TermOption> own;
  std::variant<BandCode<Dim>, CellCode<Dim>, CornerCode<Dim>> code;
  /// The term on one element in Ceres' terms, without the compiled code (energies/cost/element_cost.h).
  ElementCostFunction (*cost)(const ElementFields<Dim>&, double weight, const Material<double>&);
  /// Largest second derivative of the density where it rests; of a corner term, its scale on a cell of side 1.
  double (*modulus)(const Material<double>&);
};

}  // namespace shellmatch
