#pragma once
/// \file
/// Points of both shapes that the user knows to correspond, and the pairs that they make in the unit domain.

#include "energies/pairs/point_pairs.h"
#include "geometry/distance/signed_distance.h"
#include "geometry/surface/placement.h"
#include "matching/experiment/pair_options.h"

#include <string>
#include <string_view>
#include <vector>

namespace shellmatch {

/// A point of the reference and where it is on the template, in the user's coordinates.
template <int Dim>
struct Landmark {
  std::string name;
  Vec<Dim> on_reference, on_template;
  double weight = 1;  ///< relative to that of other landmarks; > 0
  /// Where the points were read, "points.csv, line 3", for messages; may be empty.
  std::string reference_origin = {}, template_origin = {};
  /// What the user calls the shapes, for messages: the other way round where the template is deformed.
  std::string_view reference_name = "reference", template_name = "template";
};

/// Landmarks of the shapes in the other order.
template <int Dim>
std::vector<Landmark<Dim>> exchanged(std::vector<Landmark<Dim>> landmarks);

/// Checks landmarks before the shapes are placed, so that nothing is searched with wrong ones.
/// \param reference, template_surface in the user's coordinates
/// \throws InputError that names the landmark whose point is not finite, or farther from its shape than
/// options.max_distance, or whose
///   weight is not positive
template <int Dim>
void check_landmarks(const std::vector<Landmark<Dim>>& landmarks, const LandmarkOptions& options,
                     const Surface<Dim>& reference, const Surface<Dim>& template_surface);

/// The landmarks as a term of a cascade: N landmarks of weight 1 have area(M1) / N each.
/// \param name of the term \param pose of the reference, before the placement
/// \param reference, template_shape in the unit domain, as `placement` has moved them
/// \throws InputError that names the landmark which is not finite,
///   outside of the domain,
///   or farther from its shape than options.max_distance
template <int Dim>
PairSet<Dim> landmark_pairs(const std::string& name, const std::vector<Landmark<Dim>>& landmarks,
                            const LandmarkOptions& options, const Similarity<Dim>& pose,
                            const Similarity<Dim>& placement, const SignedDistance<Dim>& reference,
                            const SignedDistance<Dim>& template_shape);

}  // namespace shellmatch
