#pragma once
/// \file
/// Estimates the size of the finest grid before a run starts, so that a run for which memory or disk are too small is
/// refused at once.

#include "geometry/surface/surface.h"
#include "matching/experiment/options.h"

#include <cstdint>
#include <string>

namespace shellmatch {

/// Upper estimates for the finest level, meant to be too large by a factor of at most about 2.
struct SizeEstimate {
  double n_nodes = 0;        ///< of the grid of phi
  double n_field_nodes = 0;  ///< sum over the shapes' own grids
  double memory_bytes = 0;   ///< at the peak of the run, in bytes
  double disk_bytes = 0;     ///< of the output folder, in bytes
};

/// Lengths (plane) or areas (space), in the unit domain, of the surfaces at which grids are refined.
struct RefinedMeasures {
  double phi = 0;     ///< refined by the grid of phi
  double fields = 0;  ///< refined by the shapes' own grids; 0 without such grids
};

/// The measures for a matching of these surfaces. \pre both lie in the unit domain
template <int Dim>
RefinedMeasures refined_measures(const Surface<Dim>& reference, const Surface<Dim>& template_shape,
                                 const ExperimentOptions& options);

/// The estimates for grids that are uniform at `min_level` and refined at the surfaces up to `max_level`.
template <int Dim>
SizeEstimate estimate_size(const RefinedMeasures& measures, int min_level, int max_level);

/// Checks that the memory of the machine and the disk suffice.
/// \param folder where files will be written; empty to leave the disk unchecked
/// \throws EnvironmentError with the size available, the size needed and the greatest level that would fit;
/// LevelTooLarge (matching/cascade/level_memory.h) if the memory that the user has given cannot suffice
template <int Dim>
void check_size(const RefinedMeasures& measures, int min_level, int max_level, const std::string& folder);

}  // namespace shellmatch
