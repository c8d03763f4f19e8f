#pragma once
/// \file
/// The terms that every element has, volume and barrier, on eight elements at a time.

#include "energies/elements/element_batch.h"
#include "energies/elements/sum_factorised_evaluator.h"
#include "energies/options.h"

namespace shellmatch {

/// Eight elements, as both terms read them, and what is computed of them.
template <int Dim>
struct CellBatch {
  ElementBatch<Dim> elements;
  SumFactorisedEvaluator<Dim, false> evaluator;
  explicit CellBatch(const ShapeTable<Dim>& shape) : evaluator(shape) {}
};

/// Weighted values of a term on each of the eight; with a gradient, adds it to that of the elements.
/// \param measure  side^Dim times the term's weight; 0 in lanes that do not count
template <int Dim>
using CellKernel = autodiff::Pack (*)(CellBatch<Dim>& batch, const ShapeTable<Dim>& shape, const EnergyOptions& options,
                                      const autodiff::Pack& measure);

template <int Dim, bool WithGradient>
CellKernel<Dim> volume_kernel(VolumeDensity density);

/// energies/terms/fold_barrier.h. NaN where an element is folded.
template <int Dim, bool WithGradient>
autodiff::Pack fold_barrier(CellBatch<Dim>& batch, double threshold, const autodiff::Pack& measure);

}  // namespace shellmatch
