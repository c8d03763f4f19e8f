#pragma once
/// \file
/// The list of all terms. To add one, write its file and add its line here (docs/adding-an-energy.md).

#include "energies/terms/bending.h"
#include "energies/terms/bending_without_p2.h"
#include "energies/terms/cauchy_green_membrane.h"
#include "energies/terms/extrapolated_bending.h"
#include "energies/terms/fold_barrier.h"
#include "energies/terms/full_volume.h"
#include "energies/terms/match.h"
#include "energies/terms/membrane.h"
#include "energies/terms/membrane_without_p2.h"
#include "energies/terms/quadratic_bending.h"
#include "energies/terms/simplified_volume.h"
#include "energies/terms/symmetric_dirichlet_volume.h"

namespace shellmatch {

template <class... Term>
struct TermList {};

/// In the order of reports. Terms of one name stand together; the first of them is the default.
template <int Dim>
using AllTerms = TermList<Match<Dim>, Membrane<Dim>, MembraneWithoutP2<Dim>, CauchyGreenMembrane<Dim>,
                          ExtrapolatedBending<Dim>, Bending<Dim>, BendingWithoutP2<Dim>, QuadraticBending<Dim>,
                          SymmetricDirichletVolume<Dim>, SimplifiedVolume<Dim>, FullVolume<Dim>, FoldBarrier<Dim>>;

}  // namespace shellmatch
