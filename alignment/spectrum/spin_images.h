#pragma once
/// \file
/// What a surface looks like around a vertex, in any position and nearly in any pose. Unlike the spectrum it is
/// extrinsic, so that it tells front from back and arms from legs, and unlike positions it does not depend on where
/// limbs point.

#include "alignment/spectrum/laplacian.h"
#include "geometry/surface/surface.h"

#include <span>
#include <vector>

namespace shellmatch {

/// Points or normals, one in each row.
using Rows3 = Eigen::Matrix<double, Eigen::Dynamic, 3>;

/// Unit normals at the vertices of a surface with these facets and the given coordinates (n x 3): means of the facets'
/// normals, weighted by area; zero where they cancel.
Rows3 vertex_normals(const std::vector<std::array<Index, 3>>& facets, const Rows3& coordinates);

/// Spin images of points of a surface: columns of unit length, histograms of the surface within a radius over distance,
/// height along the normal and angle of the normals, weighted by area (Johnson and Hebert, IEEE PAMI 21, 1999). Entries
/// are roots, so that differences are Hellinger's: their squares are 0 to 2.
class SpinImages {
 public:
  static constexpr int n_entries = 96;

  /// \param coordinates, normals n x 3; normals of unit length \param areas n, that the points stand for \param radius
  /// above 0
  SpinImages(const Rows3& coordinates, const Rows3& normals, const Eigen::VectorXd& areas, double radius);

  /// \param image of n_entries, is set to zero first
  void compute(Index point, Eigen::Ref<Eigen::VectorXf> image) const;

 private:
  int axis_;  ///< along which the points extend farthest
  double radius_;
  std::vector<Index> order_, position_;  ///< ascending along the axis; where each point stands in that order
  Rows3 coordinates_, normals_;          ///< in that order
  Eigen::VectorXf areas_;
};

/// Spin images of all vertices along smoothed normals, one below the other for each radius (96 n_radii x n), divided by
/// the root of their number. They are of what is connected to the vertex within the radius: another limb that comes
/// near in some pose is not seen.
/// \param surface, laplacian of area 1, whose root is the unit of length
/// \param radii above 0; the larger, the more a whole limb is seen, and the farther from a border something is missing
Eigen::MatrixXf spin_images(const Surface<3>& surface, const SurfaceLaplacian& laplacian,
                            std::span<const double> radii);

/// The n directions, as columns, in which the images of some surfaces differ most, the main one last. \param images
/// entries x vertices \param masses of the vertices, with sum 1 on each surface
Eigen::MatrixXf main_components(std::span<const Eigen::MatrixXf* const> images,
                                std::span<const Eigen::VectorXd* const> masses, Eigen::Index n);

}  // namespace shellmatch
