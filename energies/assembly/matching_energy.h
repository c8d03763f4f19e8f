#pragma once
/// \file
/// E[phi] = E_match + E_mem + E_bend + E_vol, and the barrier against folds, on one grid: value and gradient.

#include "energies/assembly/band.h"
#include "energies/assembly/band_report.h"
#include "energies/elements/unknowns.h"
#include "energies/elements/cell_blocks.h"
#include "energies/options.h"
#include "energies/fields/geometry_field.h"

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace shellmatch {

/// The terms, in the order of every list of term values.
enum class Term { match, membrane, bending, volume, barrier };
inline constexpr int n_terms = 5;
inline constexpr std::array<std::string_view, n_terms> term_names = {"match", "membrane", "bending", "volume",
                                                                     "barrier"};

/// One number for each term: weights, or weighted values.
struct TermValues {
  std::array<double, n_terms> v{};
  double& operator[](Term t) { return v[static_cast<int>(t)]; }
  double operator[](Term t) const { return v[static_cast<int>(t)]; }
  TermValues& operator+=(const TermValues& o) {
    for (int i = 0; i < n_terms; ++i) v[i] += o.v[i];
    return *this;
  }
  double sum() const { return (((v[0] + v[1]) + v[2]) + v[3]) + v[4]; }
};

/// The discrete energy on one grid, as a function of nodal positions. Grid, unknowns and geometry must outlive it.
template <int Dim>
class MatchingEnergy {
 public:
  /// `points_per_direction` of the Gauss rule; options.quadrature_order is what minimising uses, reports may
  /// use more. sigma: half width of the band.
  MatchingEnergy(const Unknowns<Dim>& unknowns, const GeometryPair<Dim>& geometry, const EnergyOptions& options,
                 double sigma, int points_per_direction);

  /// The part that these elements contribute: values only. The elements must outlive it too.
  MatchingEnergy(std::span<const Element<Dim>> elements, const GeometryPair<Dim>& geometry, const EnergyOptions& options,
                 double sigma, int points_per_direction);

  /// Weighted values of the terms; where `gradient` is not empty, the gradient by the unknowns (size
  /// unknowns.size()). False where a term cannot be evaluated: a fold under a density that forbids it, or
  /// anything that is not finite. \pre phi has one position for each node, hanging nodes consistent.
  /// \param element_gradients  if not null, and the gradient is wanted: what it is the sum of, by every element's
  ///   corners, element after element
  bool evaluate(std::span<const Vec<Dim>> phi, const TermValues& weights, TermValues& values,
                std::span<double> gradient, std::vector<double>* element_gradients = nullptr) const;

  /// The values, and how the band lies in the template, even where they cannot be evaluated.
  bool report(std::span<const Vec<Dim>> phi, const TermValues& weights, TermValues& values, BandSums& band) const;

  const Band<Dim>& band() const { return band_; }
  const ShapeTable<Dim>& shape() const { return shape_; }
  /// \pre it is of a whole grid
  const CellBlocks<Dim>& cell_blocks() const { return *cell_blocks_; }

 private:
  // On the elements of one block; `gradients` are those of its elements. `band_sums`, if not null, is added to.
  template <bool WithGradient>
  TermValues all_terms(const Chunk& cells, std::span<const Vec<Dim>> phi, const TermValues& weights, double* gradients,
                       BandSums* band_sums) const;
  // Volume and barrier; sets the gradients. False where there is a fold, found out by the barrier: that ends the block.
  template <bool WithGradient>
  bool set_cell_terms(const Chunk& cells, std::span<const Vec<Dim>> phi, const TermValues& weights, TermValues& values,
                      double* gradients) const;
  // Match, membrane and bending; adds to the gradients.
  template <bool WithGradient>
  void add_band_terms(const Chunk& cells, std::span<const Vec<Dim>> phi, const TermValues& weights, TermValues& values,
                      double* gradients, BandSums* band_sums) const;

  std::span<const Element<Dim>> elements_;
  const GeometryField<Dim>* target_;
  EnergyOptions options_;
  ShapeTable<Dim> shape_;
  Band<Dim> band_;
  std::optional<CellBlocks<Dim>> cell_blocks_;  ///< none where only values are wanted
};

/// Weights of the terms for given nu and c_vol: 1/nu, delta, delta^3 and c_vol times the options' factors,
/// and the barrier's.
TermValues term_weights(const EnergyOptions& options, double nu, double volume_weight);

}  // namespace shellmatch
