#pragma once
/// \file
/// What can be chosen of the energy. Lengths are in units of the domain's side.

#include "base/options.h"

namespace shellmatch {

enum class VolumeDensity { simplified, full, symmetric_dirichlet };
template <>
struct EnumNames<VolumeDensity> {
  static constexpr std::pair<VolumeDensity, std::string_view> names[] = {
      {VolumeDensity::simplified, "simplified"},
      {VolumeDensity::full, "full"},
      {VolumeDensity::symmetric_dirichlet, "symmetric_dirichlet"}};
};

/// What the membrane term measures; all but thin_shell are there to compare with (energies/terms/integrands.h).
enum class MembraneModel { thin_shell, no_p2, cauchy_green };
template <>
struct EnumNames<MembraneModel> {
  static constexpr std::pair<MembraneModel, std::string_view> names[] = {
      {MembraneModel::thin_shell, "thin_shell"},
      {MembraneModel::no_p2, "no_p2"},
      {MembraneModel::cauchy_green, "cauchy_green"}};
};

/// What the bending term measures, likewise.
enum class BendingModel { thin_shell, no_p2, quadratic };
template <>
struct EnumNames<BendingModel> {
  static constexpr std::pair<BendingModel, std::string_view> names[] = {
      {BendingModel::thin_shell, "thin_shell"}, {BendingModel::no_p2, "no_p2"}, {BendingModel::quadratic, "quadratic"}};
};

enum class BoundaryCondition { neumann, dirichlet };
template <>
struct EnumNames<BoundaryCondition> {
  static constexpr std::pair<BoundaryCondition, std::string_view> names[] = {
      {BoundaryCondition::neumann, "neumann"}, {BoundaryCondition::dirichlet, "dirichlet"}};
};

/// Weights and material of the energy E = E_match + E_mem + E_bend + E_vol (paper, section 3).
struct EnergyOptions {
  double lambda = 1, mu = 1;
  double delta = 1;
  double match_weight = 1, membrane_weight = 1, bending_weight = 1, volume_weight = 1;
  MembraneModel membrane = MembraneModel::thin_shell;
  BendingModel bending = BendingModel::thin_shell;
  VolumeDensity volume = VolumeDensity::symmetric_dirichlet;
  BoundaryCondition boundary = BoundaryCondition::neumann;
  double fold_barrier = 1, fold_threshold = 0.1;
  int quadrature_order = 2;
  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("lambda", self.lambda, {.unit = "energy/volume", .min = 0, .meaning = "first Lame coefficient of W"});
    visit("mu", self.mu, {.unit = "energy/volume", .min = 0, .min_excluded = true, .meaning = "second Lame coefficient (shear modulus) of W"});
    visit("delta", self.delta, {.unit = "length", .min = 0, .meaning = "thickness of the shell: membrane weighs delta, bending delta^3"});
    visit("match_weight", self.match_weight, {.min = 0, .meaning = "factor on the match term; 0 switches it off"});
    visit("membrane_weight", self.membrane_weight, {.min = 0, .meaning = "factor on the membrane term; 0 switches it off"});
    visit("bending_weight", self.bending_weight, {.min = 0, .meaning = "factor on the bending term; 0 switches it off"});
    visit("volume_weight", self.volume_weight, {.min = 0, .meaning = "factor on the volume term; 0 switches it off"});
    visit("membrane", self.membrane, {.meaning = "thin_shell is the paper's; no_p2 leaves out the projection P2, cauchy_green takes W of the Cauchy-Green tensor: both lose what P2 is for, there to compare with, first-order methods only"});
    visit("bending", self.bending, {.meaning = "thin_shell is the paper's; no_p2 leaves out the projection P2, quadratic is |Dphi^T S2 Dphi - S1|^2: both there to compare with, first-order methods only"});
    visit("volume", self.volume, {.meaning = "density of the volume term: W itself (simplified), the paper's W_hat (full), or symmetric Dirichlet"});
    visit("boundary", self.boundary, {.meaning = "neumann: the domain's boundary is free; dirichlet: phi = id there"});
    visit("fold_barrier", self.fold_barrier, {.unit = "energy/volume", .min = 0, .meaning = "kappa, weight of the barrier that keeps det Dphi > 0 throughout every cell; 0 switches it off"});
    visit("fold_threshold", self.fold_threshold, {.min = 0, .max = 0.9, .min_excluded = true, .meaning = "d0: the barrier acts on cells where a Bernstein coefficient of det Dphi is below this"});
    visit("quadrature_order", self.quadrature_order, {.unit = "points per direction", .min = 1, .max = 5, .meaning = "Gauss points for minimising"});
  }
};

}  // namespace shellmatch
