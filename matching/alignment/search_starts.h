#pragma once
/// \file
/// Starts of a cascade from the searches of the room alignment/, in the user's coordinates.

#include "matching/alignment/choose_start.h"
#include "matching/experiment/align_options.h"
#include "matching/input/shape_pair.h"

namespace shellmatch {

/// By spectra for surfaces, one with large gaps as a part of the other and without what was made up, by elastic paths
/// for outlines: starts with pairs. \param landmarks for find_pairs(); outlines need none \throws InputError as
/// find_pairs(), find_partial_pairs(), find_outline_pairs()
StartSearch<3> search_starts(const ShapePair<3>& shapes, const std::vector<Landmark<3>>& landmarks,
                             const AlignOptions& options);
/// The same of the smaller one as a part of the other, however small its gaps are.
StartSearch<3> search_partial_starts(const ShapePair<3>& shapes, const std::vector<Landmark<3>>& landmarks,
                                     const AlignOptions& options);
/// The same of closed surfaces, however much was made up to close them. If that is more than least_of_part, no pair
/// lies on it.
StartSearch<3> search_whole_starts(const ShapePair<3>& shapes, const std::vector<Landmark<3>>& landmarks,
                                   const AlignOptions& options);
StartSearch<2> search_starts(const ShapePair<2>& shapes, const std::vector<Landmark<2>>& landmarks,
                             const AlignOptions& options);

/// By distance, for surfaces without features: the best pose alone, as others differ from it by what symmetry there is,
/// which the energy cannot judge. \param landmarks judge it where there are four \throws InputError as
/// find_rigid_pairs()
StartSearch<3> search_poses(const ShapePair<3>& shapes, const std::vector<Landmark<3>>& landmarks,
                            const AlignOptions& options);

}  // namespace shellmatch
