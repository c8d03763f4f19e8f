#pragma once
/// \file
/// E[phi] = E_match + E_mem + E_bend + E_vol, and the barrier against folds, on one grid: value and gradient.

#include "energies/elements/band.h"
#include "energies/assembly/band_report.h"
#include "energies/compiled/energy_terms.h"
#include "energies/elements/unknowns.h"
#include "energies/elements/cell_blocks.h"
#include "energies/options.h"
#include "energies/fields/geometry_field.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace shellmatch {

/// The discrete energy on one grid, as a function of nodal positions. Grid, unknowns and geometry must outlive it.
template <int Dim>
class MatchingEnergy {
 public:
  /// `points_per_direction` of the Gauss rule; options.quadrature_order is what minimising uses, reports may
  /// use more. sigma: half width of the band.
  MatchingEnergy(const Unknowns<Dim>& unknowns, const GeometryPair<Dim>& geometry, const EnergyOptions& options,
                 double sigma, int points_per_direction);

  /// The same with terms of one's own choice, among them such as are not in energies/terms/list.h.
  MatchingEnergy(const Unknowns<Dim>& unknowns, const GeometryPair<Dim>& geometry,
                 std::shared_ptr<const EnergyTerms<Dim>> terms, double sigma, int points_per_direction);

  /// The part that these elements contribute: values only. The elements must outlive it too.
  MatchingEnergy(std::span<const Element<Dim>> elements, const GeometryPair<Dim>& geometry,
                 std::shared_ptr<const EnergyTerms<Dim>> terms, double sigma, int points_per_direction);

  /// Weighted values of the terms; where `gradient` is not empty, the gradient by the unknowns (size
  /// unknowns.size()). False where a term cannot be evaluated: a fold under a density that forbids it, or
  /// anything that is not finite. \pre phi has one position for each node, hanging nodes consistent.
  /// \param element_gradients  if not null, and the gradient is wanted: what it is the sum of, by every element's
  ///   corners, element after element
  bool evaluate(std::span<const Vec<Dim>> phi, const TermValues& weights, TermValues& values,
                std::span<double> gradient, std::vector<double>* element_gradients = nullptr) const;

  /// The values, and how the band lies in the template, even where they cannot be evaluated.
  bool report(std::span<const Vec<Dim>> phi, const TermValues& weights, TermValues& values, BandSums& band) const;

  const EnergyTerms<Dim>& terms() const { return *terms_; }
  const Band<Dim>& band() const { return band_; }
  const ShapeTable<Dim>& shape() const { return shape_; }
  const GeometryField<Dim>& target() const { return *target_; }
  /// \pre it is of a whole grid
  const CellBlocks<Dim>& cell_blocks() const { return *cell_blocks_; }

 private:
  // On the cells of one block: adds to `values`, one for each term; `gradients` are those of its elements. `band_sums`,
  // if not null, is added to.
  template <bool WithGradient>
  void add_terms(const Chunk& cells, std::span<const Vec<Dim>> phi, const TermValues& weights, double* values,
                 double* gradients, BandSums* band_sums) const;
  // Terms of cells and corners; sets the gradients. False where one of them is not finite: that ends the block.
  template <bool WithGradient>
  bool set_cell_terms(const Chunk& cells, std::span<const Vec<Dim>> phi, const TermValues& weights, double* values,
                      double* gradients) const;
  // Terms of the band; adds to the gradients.
  template <bool WithGradient>
  void add_band_terms(const Chunk& cells, std::span<const Vec<Dim>> phi, const TermValues& weights, double* values,
                      double* gradients, BandSums* band_sums) const;

  std::span<const Element<Dim>> elements_;
  const GeometryField<Dim>* target_;
  std::shared_ptr<const EnergyTerms<Dim>> terms_;
  ShapeTable<Dim> shape_;
  Band<Dim> band_;
  std::optional<CellBlocks<Dim>> cell_blocks_;  ///< none where only values are wanted
};

}  // namespace shellmatch
