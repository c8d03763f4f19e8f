#pragma once
/// \file
/// The matching energy E[phi] = E_match + E_mem + E_bend + E_vol + E_barrier + E_points on one grid, with its gradient.

#include "energies/assembly/band_report.h"
#include "energies/compiled/energy_terms.h"
#include "energies/elements/band.h"
#include "energies/elements/band_mask.h"
#include "energies/elements/cell_blocks.h"
#include "energies/elements/unknowns.h"
#include "energies/energy_options.h"
#include "energies/fields/geometry_field.h"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace shellmatch {

/// The discrete energy on one grid as a function of the nodal positions. Grid, unknowns and geometry must outlive it.
template <int Dim>
class MatchingEnergy {
 public:
  /// \param points_per_direction of the Gauss rule: options.quadrature_order for minimisation, more for reports
  /// \param sigma half width of the band
  MatchingEnergy(const Unknowns<Dim>& unknowns, const GeometryPair<Dim>& geometry, const EnergyOptions& options,
                 double sigma, int points_per_direction);

  /// The same with given terms, which need not be in energies/terms/list.h, and to which others may be added later.
  MatchingEnergy(const Unknowns<Dim>& unknowns, const GeometryPair<Dim>& geometry,
                 std::shared_ptr<const EnergyTerms<Dim>> terms, double sigma, int points_per_direction);

  /// The contribution of some elements to the energy: values only. The elements must outlive this object.
  MatchingEnergy(std::span<const Element<Dim>> elements, const GeometryPair<Dim>& geometry,
                 std::shared_ptr<const EnergyTerms<Dim>> terms, double sigma, int points_per_direction);

  /// Multiplies the weights of the band by mask.reference_weight(x), once for all. The mask must outlive this object.
  /// \pre the first call
  void set_mask(const BandMask<Dim>& mask);

  /// Multiplies them by mask.template_weight(phi(x)) as well. The energy then is that of these weights: they do not
  /// move with phi until the next call. Without a mask, nothing happens. Not during an evaluation.
  void refresh_mask(std::span<const Vec<Dim>> phi);

  /// Sets the values of the terms of points, which depend on no quadrature. \pre values.size() == n_terms()
  void set_point_values(std::span<const Vec<Dim>> phi, const TermValues& weights, TermValues& values) const;

  /// The size of `weights` and `values` below.
  std::size_t n_terms() const { return terms_->size(); }
  std::vector<std::string> term_names() const { return terms_->names(); }

  /// Evaluates the terms' weighted values and, where `gradient` is not empty, the gradient by the unknowns (size
  /// unknowns.size()).
  /// \return false where a term cannot be evaluated: a fold under a density that forbids folds, or a value that is not
  ///   finite
  /// \param element_gradients if not null and the gradient is requested: the gradient by the corner positions of each
  ///   element, n_corners * Dim entries for each
  /// \pre phi has one position for each node, with hanging nodes consistent
  bool evaluate(std::span<const Vec<Dim>> phi, const TermValues& weights, TermValues& values,
                std::span<double> gradient, std::vector<double>* element_gradients = nullptr) const;

  /// The values, and the measures of the band; works where evaluate() returns false, too.
  bool report(std::span<const Vec<Dim>> phi, const TermValues& weights, TermValues& values, BandSums& band) const;

  std::span<const Element<Dim>> elements() const { return elements_; }
  const EnergyTerms<Dim>& terms() const { return *terms_; }
  const Band<Dim>& band() const { return band_; }
  const ShapeTable<Dim>& shape() const { return shape_; }
  const GeometryField<Dim>& target() const { return *target_; }
  /// The blocks of cells. \pre this energy is of a whole grid
  const CellBlocks<Dim>& cell_blocks() const { return *cell_blocks_; }

 private:
  // Adds the terms of the cells of one block to `values` (one for each term), their element gradients to `gradients`,
  // and the sums of the band to `band_sums` where that is not null.
  template <bool WithGradient>
  void add_terms(const Chunk& cells, std::span<const Vec<Dim>> phi, const TermValues& weights, double* values,
                 double* gradients, BandSums* band_sums) const;
  // The same by Ceres' cost functions (energies/assembly/ceres_evaluator.cpp).
  template <bool WithGradient>
  void add_costs(const Chunk& cells, std::span<const Vec<Dim>> phi, const TermValues& weights, double* values,
                 double* gradients) const;
  // Terms of cells and corners: adds to `values`, sets `gradients`. Returns false at the first value that is not
  // finite.
  template <bool WithGradient>
  bool set_cell_terms(const Chunk& cells, std::span<const Vec<Dim>> phi, const TermValues& weights, double* values,
                      double* gradients) const;
  // Terms of the band: adds to `values` and `gradients`.
  template <bool WithGradient>
  void add_band_terms(const Chunk& cells, std::span<const Vec<Dim>> phi, const TermValues& weights, double* values,
                      double* gradients, BandSums* band_sums) const;

  // Terms of points: adds to `values` and, if not null, to `gradients`.
  void add_point_terms(const Chunk& cells, std::span<const Vec<Dim>> phi, const TermValues& weights, double* values,
                       double* gradients) const;

  std::span<const Element<Dim>> elements_;
  const GeometryField<Dim>* target_;
  std::shared_ptr<const EnergyTerms<Dim>> terms_;
  ShapeTable<Dim> shape_;
  Band<Dim> band_;
  const BandMask<Dim>* mask_ = nullptr;
  std::optional<CellBlocks<Dim>> cell_blocks_;  ///< none for an energy of values only
};

}  // namespace shellmatch
