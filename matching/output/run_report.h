#pragma once
/// \file
/// What a run has to say about its result: fields, figures and pictures for the output folder.

#include "geometry/distance/signed_distance.h"
#include "geometry/surface/surface.h"
#include "matching/cascade/cascade.h"
#include "matching/output/deformation_file.h"
#include "matching/output/summary.h"

#include <string>
#include <utility>
#include <vector>

namespace shellmatch {

/// The same surface with its facets split until none is longer than `length`: what is measured is then the image
/// of the curve, not the polygon through the images of its corners. In space the surface itself, as meshes are as
/// fine as their shape asks for.
template <int Dim>
Surface<Dim> subdivided(const Surface<Dim>& surface, double length);

/// The surface with its vertices moved by phi; unit domain.
template <int Dim>
Surface<Dim> deformed_surface(const Surface<Dim>& reference, const Octree<Dim>& grid, const std::vector<Vec<Dim>>& phi);

template <int Dim>
TwoSidedDistance two_sided_distance(const Surface<Dim>& deformed, const SignedDistance<Dim>& template_distance);

LevelSummary level_summary(const LevelResult& result, const IterationRecord& last);

/// Area (length) and angle distortion and facets that face away, over all facets.
template <int Dim>
void add_distortion(MatchSummary& summary, const Surface<Dim>& reference, const Surface<Dim>& deformed,
                    const SignedDistance<Dim>& template_distance);

/// True positions of some of the reference's vertices, user's coordinates.
template <int Dim>
using Correspondence = std::vector<std::pair<Index, Vec<Dim>>>;

/// Reads lines "index x y z" (plane: "index x y"); # begins a comment. \throws InputError with file and line
template <int Dim>
Correspondence<Dim> read_correspondence(const std::string& path, std::size_t n_vertices);

/// Mean distance of the vertices from their true positions.
template <int Dim>
double correspondence_error(const Correspondence<Dim>& truth, const std::vector<Vec<Dim>>& vertices);

/// The reference as it was read, moved by the deformation, with the attributes distance_to_template (user's unit)
/// and area_ratio (length_ratio in the plane) besides its own.
template <int Dim>
OriginalShape<Dim> deformed_original(const OriginalShape<Dim>& reference, const Deformation<Dim>& deformation,
                                     const SignedDistance<Dim>& template_distance);

/// d1, d2, n1, n2 and the roots of the classified shape operators at the nodes, or what the options took in their place.
template <int Dim>
std::vector<NodalField> nodal_fields(const CoefficientFields<Dim>& reference, const CoefficientFields<Dim>& target,
                                     const ExperimentOptions& options);

/// For each leaf: is it in the band, and the lower bound of det Dphi.
template <int Dim>
std::vector<CellField> cell_fields(const Octree<Dim>& grid, const std::vector<Vec<Dim>>& phi,
                                   const std::vector<double>& distance1, double sigma);

}  // namespace shellmatch
