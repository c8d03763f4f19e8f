#pragma once
/// \file
/// The terms of point pairs that a matching begins with, and the band of a cascade that they lead.

#include "energies/pairs/point_pairs.h"
#include "geometry/distance/signed_distance.h"
#include "matching/alignment/alignment.h"
#include "matching/experiment/options.h"

#include <vector>

namespace shellmatch {

/// Whether no part of either surface lies farther than 0.05 diagonals of the template from the other: no limb begins
/// elsewhere then, and pairs that do are wrong. \param reference, template_shape in the pose from which a matching
/// begins
template <int Dim>
bool lie_near(const SignedDistance<Dim>& reference, const SignedDistance<Dim>& template_shape);

/// Terms `landmarks` and `alignment`, as far as there are such pairs.
/// \param reference, template_shape in the unit domain, after the pose of `alignment` and `placement`
/// \throws InputError as landmark_pairs
template <int Dim>
std::vector<PairSet<Dim>> known_pairs(const std::vector<Landmark<Dim>>& landmarks, const Alignment<Dim>& alignment,
                                      const ExperimentOptions& options, const Similarity<Dim>& placement,
                                      const SignedDistance<Dim>& reference, const SignedDistance<Dim>& template_shape);

/// Options for the cascade after this alignment: the band of surfaces with pairs is as wide on coarse levels as
/// align.coarse_sigma_cells says, and what begins near everywhere is minimised less exactly before the last level.
template <int Dim>
ExperimentOptions cascade_options(const ExperimentOptions& options, const Alignment<Dim>& alignment);

}  // namespace shellmatch
