#pragma once
/// \file
/// What a deformation does to the surface it moves: stretching, shearing, folding. All functions compare two
/// surfaces with the same facets, before (`reference`) and after (`deformed`).

#include "geometry/distance/signed_distance.h"

#include <cstddef>
#include <vector>

namespace shellmatch {

/// Measure of every deformed facet divided by that of the same reference facet: area ratio in space, length
/// ratio in the plane. NaN for a reference facet without measure.
template <int Dim>
std::vector<double> facet_measure_ratios(const Surface<Dim>& reference, const Surface<Dim>& deformed);

/// The same for every vertex: sums over its facets, divided. NaN where the reference facets have no measure
/// or there are none.
template <int Dim>
std::vector<double> vertex_measure_ratios(const Surface<Dim>& reference, const Surface<Dim>& deformed);

/// Singular values of the linear map that carries a reference triangle to the deformed one.
struct Stretch {
  double s1, s2;  ///< s1 >= s2 >= 0
};
/// One for each facet; NaN for a reference triangle without area.
std::vector<Stretch> principal_stretches(const Surface<3>& reference, const Surface<3>& deformed);

/// s1 / s2 for each facet: 1 where all angles are kept, infinite where the deformed triangle has no area. In
/// the plane, where a segment has no angles, 1.
template <int Dim>
std::vector<double> angle_distortions(const Surface<Dim>& reference, const Surface<Dim>& deformed);

/// Facets whose normal and that of the template's facet nearest to their centre enclose more than a right
/// angle.
template <int Dim>
std::size_t count_facing_away(const Surface<Dim>& deformed, const SignedDistance<Dim>& template_distance);

/// Quantiles of all values that are not NaN.
struct Quantiles {
  double p5, median, p95;
};
Quantiles quantiles(std::vector<double> values);

template <int Dim>
struct Distortion {
  Quantiles measure_ratio;                        ///< of facets
  Quantiles angle_distortion;                     ///< of facets
  std::size_t n_collapsed = 0;                    ///< facets with a measure ratio below 0.01
  std::size_t n_facing_away = 0;                  ///< from the template's normal
  std::size_t n_self_intersecting = 0;            ///< deformed facets that meet others than their neighbours
  std::size_t n_self_intersecting_reference = 0;  ///< the same before
};

/// All of the above. \pre `deformed` has the facets of `reference`.
template <int Dim>
Distortion<Dim> distortion(const Surface<Dim>& reference, const Surface<Dim>& deformed,
                           const SignedDistance<Dim>& template_distance);

}  // namespace shellmatch
