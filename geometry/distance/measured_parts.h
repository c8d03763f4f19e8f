#pragma once
/// \file
/// Which points of two surfaces distances are measured at, where one of them has gaps.

#include "geometry/distance/observed_part.h"

#include <vector>

namespace shellmatch {

template <int Dim>
class MeasuredParts {
 public:
  /// All points.
  MeasuredParts() = default;
  /// \param reference, its_surface  before it is deformed, in the coordinates of `reference`
  MeasuredParts(ObservedPart<Dim> reference, const Surface<Dim>& its_surface, ObservedPart<Dim> template_part);

  bool is_all() const { return margins_.empty() && template_part_.is_all(); }

  /// For each vertex of the deformed reference: is it observed, and has the template data next to it? Empty for all.
  /// \pre the vertices are those of the constructor
  std::vector<char> of_deformed(const Surface<Dim>& deformed) const;
  /// The same for some of the vertices.
  std::vector<char> of_deformed(const Surface<Dim>& deformed, const std::vector<Index>& vertices) const;
  /// For each facet of the reference: is its centre observed, and has the template data next to it after it was
  /// deformed? Empty for all.
  std::vector<char> of_facets(const Surface<Dim>& reference, const Surface<Dim>& deformed) const;
  /// For each point: has the reference data at the nearest point of its deformed surface?
  std::vector<char> near_observed(const std::vector<Vec<Dim>>& points, const Surface<Dim>& deformed) const;
  /// For each point of the template: is it observed, and has the reference data at the nearest point of its deformed
  /// surface? Empty for all.
  std::vector<char> of_template(const std::vector<Vec<Dim>>& points, const Surface<Dim>& deformed) const;
  /// The same. \param facets of the deformed surface, each nearest to one of the points
  std::vector<char> of_template(const std::vector<Vec<Dim>>& points, const Surface<Dim>& deformed,
                                const std::vector<Index>& facets) const;

 private:
  std::vector<char> near_observed(const std::vector<Vec<Dim>>& points, const Surface<Dim>& deformed,
                                  const std::vector<Index>& facets) const;

  std::vector<double> margins_;  ///< of the reference's vertices, up to what matters; empty where it has no gaps
  ObservedPart<Dim> reference_part_, template_part_;
};

}  // namespace shellmatch
