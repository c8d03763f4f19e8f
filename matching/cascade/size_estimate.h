#pragma once
/// \file
/// How large will the grid become? Asked before a run starts, so that one which cannot end does not begin.

#include "geometry/surface/surface.h"
#include "matching/experiment/options.h"

#include <cstdint>
#include <string>

namespace shellmatch {

/// Of the finest level, from above: meant to be too large by a factor of at most about 2.
struct SizeEstimate {
  double n_nodes = 0;        ///< of the grid of phi
  double n_field_nodes = 0;  ///< of the shapes' own grids
  double memory_bytes = 0;   ///< at the peak of the run
  double disk_bytes = 0;     ///< of the output folder
};

/// Lengths (plane) or areas (space), in the unit domain, of the surfaces that grids are refined at.
struct RefinedMeasures {
  double phi = 0;     ///< by the grid of phi
  double fields = 0;  ///< by the shapes' own grids, 0 for none
};

/// What a matching of these surfaces refines at. \param reference, template_shape in the unit domain
template <int Dim>
RefinedMeasures refined_measures(const Surface<Dim>& reference, const Surface<Dim>& template_shape,
                                 const ExperimentOptions& options);

/// Of grids that are uniform at `min_level` and refined to `max_level` at the surfaces.
template <int Dim>
SizeEstimate estimate_size(const RefinedMeasures& measures, int min_level, int max_level);

/// \param folder where files are to be written; empty where there will be none, and the disk does not count
/// \throws EnvironmentError if the machine has too little memory, or the disk of `folder` too little room, that says
///   how much is there, how much is needed and which largest level would do
template <int Dim>
void check_size(const RefinedMeasures& measures, int min_level, int max_level, const std::string& folder);

}  // namespace shellmatch
