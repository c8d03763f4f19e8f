#pragma once
/// \file
/// Computes the figures of a summary from the results of a matching.

#include "geometry/distance/signed_distance.h"
#include "geometry/surface/surface.h"
#include "matching/cascade/level_minimisation.h"
#include "matching/level/observed_mask.h"
#include "matching/result/match_summary.h"

#include <functional>

namespace shellmatch {

/// Both distances, and where they are greatest.
template <int Dim>
struct LocatedDistance {
  TwoSidedDistance figures;
  Vec<Dim> farthest_of_deformed, farthest_of_template;
};

/// Distances between the deformed reference and the template, over the parts of both that were observed. Large facets
/// are subdivided before they are deformed, as phi bends them, and those of the template are measured within. \param
/// deform  moves a surface's vertices \param side    of the finest cells of the deformation, unit domain \param
/// most_points > 0; of surfaces with more vertices, every second, third, ... is measured: `on_the_way` where the
/// figures are no result
template <int Dim>
LocatedDistance<Dim> two_sided_distance(const Surface<Dim>& reference,
                                        const std::function<Surface<Dim>(const Surface<Dim>&)>& deform,
                                        const SignedDistance<Dim>& template_distance, const ObservedPair<Dim>& observed,
                                        double side, std::size_t most_points = std::numeric_limits<std::size_t>::max());

/// Means over so many points are within a few percent of those over all.
inline constexpr std::size_t on_the_way = 6000;

LevelSummary level_summary(const LevelResult& result, const IterationRecord& last);

/// The surface with some of its facets. \param measured one entry for each facet; empty for all
template <int Dim>
Surface<Dim> measured_facets(const Surface<Dim>& surface, const std::vector<char>& measured);

/// Adds area (length) and angle distortion and the number of flipped facets, over all facets; nothing where there is
/// none. \pre the surfaces have the same facets
template <int Dim>
void add_distortion(MatchSummary& summary, const Surface<Dim>& reference, const Surface<Dim>& deformed,
                    const SignedDistance<Dim>& template_distance);

/// The vertex of the deformed surface around which areas and angles (lengths) have changed most. \pre the surfaces have
/// the same facets
template <int Dim>
Vec<Dim> most_distorted_place(const Surface<Dim>& reference, const Surface<Dim>& deformed);

}  // namespace shellmatch
