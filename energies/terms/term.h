#pragma once
/// \file
/// What a term of the energy is: one type in one file of this folder, and one line in energies/terms/list.h
/// (docs/adding-an-energy.md). Value, gradient, Newton's model, Ceres' cost functors, checks, reports and options are
/// made from it.
///
/// A term is a functor of the fields that it reads at a point, which gives its argument A, and a density W; the energy
/// is the integral of W(A):
///
///     template <int Dim>
///     struct NormalAlignment : BandTerm<Dim> {                      where it is integrated
///       static constexpr TermInfo info{...};
///       using Reads = DependsOn<Dphi, TargetNormal, ReferenceNormal>;    the functor's arguments, in order
///                                                                        (energies/terms/depends_on.h)
///       using Density = SquareDensity<Dim>;                              W (energies/densities/material.h)
///
///       template <class T, class P>
///       constexpr SmallVec<T, Dim> operator()(const SmallMat<T, Dim>& dphi, const SmallVec<T, Dim>& n2,
///                                             const SmallVec<P, Dim>& n1) const;
///     };
///
/// Its base says where it is integrated:
///
///     BandTerm    over the band, weighted with eta_sigma(d1): it reads any field
///     CellTerm    over the domain: it reads Phi, Dphi, its own options and its own fields
///     CornerTerm  a function of the positions of a cell's corners:
///                 operator()(corners, factor) is an array, W acts on each entry,
///                 and the term is the cell's volume times their mean
///
/// ElementCost<Term> (energies/cost/element_cost.h) is the same as a functor in Ceres' convention over the degrees of
/// freedom of one element, `bool operator()(const T* dofs, T* energy) const`, and for squares ElementResiduals<Term>
/// `(const T* dofs, T* residuals)`: what `energy.evaluator: ceres` evaluates. compile_term<Term>() makes vector code
/// from the same functor.
///
/// A CornerTerm also defines `n_arguments`, the size of that array; `scale(inverse_side, material)`, the factor handed
/// to the functor, for a number and for a Pack of them; `may_act(batch, material)`, a Pack that is 0 only in the lanes
/// of elements on which the term and its derivatives vanish, and nowhere negative. Its density takes one number
/// (energies/terms/fold_barrier.h).
///
/// A functor is written once over a scalar T that is differentiated (what depends on phi) and a scalar P that is not.
/// The same text runs on numbers, on ceres::Jet, and on the recording scalar from which the compiled code is made
/// (energies/autodiff): it must not branch on data; max_of is the one choice there is.
///
/// Optional members:
///
///     static constexpr bool is_tangential = true
///         the argument is P2 X P1 for some X, to which n2 n1^T is added (that is not part of the functor).
///         Newton's model is then made in tangent frames. The argument has no direction of its own in the reference:
///         where Dphi becomes Dphi Q, n1 Q^T n1 and r1 Q^T r1 Q, A becomes A Q for orthogonal Q
///
///     static constexpr std::array<TermOption, n> own
///         options of its own,
///         which the functor gets as OwnOptions, in this order

#include "base/options.h"
#include "energies/densities/material.h"
#include "energies/fields/coefficients.h"
#include "energies/terms/depends_on.h"

#include <array>
#include <span>
#include <string_view>

namespace shellmatch {

/// A number that the user chooses.
struct TermOption {
  std::string_view name;  ///< key in the section `energy`
  double value = 0;       ///< default
  OptionInfo info{};
};

/// What the schedule and the experiment give to the weights of terms.
struct TermScales {
  double nu = 1;      ///< of the match term; length^2 per energy
  double volume = 1;  ///< c_vol
  double delta = 1;   ///< thickness of the shell, length
};

/// The weight of a term that no schedule scales.
constexpr double unscaled(double factor, const TermScales&) { return factor; }

struct TermInfo {
  std::string_view name;  ///< column in history.csv and name in summary.json; terms of one name exclude each other
  std::string_view model = "";  ///< value of the option of that name, which chooses among them; "" for the only one
  std::string_view meaning = "";
  /// Factor that the user chooses; terms of one name share that of the first of them in the list. 0 switches off.
  TermOption weight{};
  /// Weight in the energy for that factor.
  double (*scaled)(double factor, const TermScales& scales) = unscaled;
  bool forbids_folds = false;  ///< infinite where det Dphi <= 0
};

/// Bases, which say where a term is integrated.
template <int Dim>
struct BandTerm {
  static constexpr int dim = Dim;
  static constexpr bool is_tangential = false;
  static constexpr std::array<TermOption, 0> own{};
};
template <int Dim>
struct CellTerm {
  static constexpr int dim = Dim;
  static constexpr std::array<TermOption, 0> own{};
};
template <int Dim>
struct CornerTerm {
  static constexpr int dim = Dim;
  static constexpr std::array<TermOption, 0> own{};
};

}  // namespace shellmatch
