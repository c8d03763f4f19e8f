#pragma once
/// \file
/// A map that is given on a surface: facets go to facets, and points beside the surface go with the nearest facet.

#include "geometry/distance/facet_tree.h"
#include "geometry/surface/surface.h"

#include <vector>

namespace shellmatch {

/// Carries a surface to another position of its vertices. Continuous on the surface, and not across the places that are
/// as near to one of its parts as to another: no map of space.
template <int Dim>
class SurfaceBend {
 public:
  /// \param bent the vertices of `surface` elsewhere \pre there are facets, and all coordinates are finite
  SurfaceBend(Surface<Dim> surface, std::vector<Vec<Dim>> bent);

  /// A point at this distance and in this direction from the same place of the bent surface.
  Vec<Dim> operator()(const Vec<Dim>& x) const { return carried(surface_, tree_, bent_, x); }
  /// From the bent surface back.
  Vec<Dim> inverse(const Vec<Dim>& y) const { return carried(bent_, bent_tree_, surface_, y); }

  const Surface<Dim>& surface() const { return surface_; }
  const Surface<Dim>& bent() const { return bent_; }

  /// Of the vertices of a surface from this one before its bend, the largest; 0 without vertices.
  double farthest(const Surface<Dim>& surface) const;

  /// Moves the vertices of a surface that lies on or beside this one.
  void apply(Surface<Dim>& surface) const;
  /// The surface of a shape, and its observed and unobserved parts; the original stays.
  void apply(Shape<Dim>& shape) const;

 private:
  static Vec<Dim> carried(const Surface<Dim>& from, const FacetTree<Dim>& tree, const Surface<Dim>& to,
                          const Vec<Dim>& x);

  Surface<Dim> surface_, bent_;
  FacetTree<Dim> tree_, bent_tree_;
};

}  // namespace shellmatch
