#pragma once
/// \file
/// A surface with borders, or the whole that it is a part of, with what a search of one in the other needs.

#include "alignment/options.h"
#include "alignment/spectrum/edge_graph.h"
#include "alignment/spectrum/eigenpairs.h"
#include "alignment/spectrum/vertex_normals.h"

#include <Eigen/Core>

namespace shellmatch {

/// Radius of the spin images; nearer borders they lack what was cut away, so that it is less than that of whole
/// surfaces.
inline constexpr double part_spin_radius = 0.08;

/// Lengths are in a unit that part and whole share: the root of the area of the whole. n vertices, k eigenpairs.
struct PartialShape {
  Surface<3> surface;
  EdgeGraph graph;
  Eigen::VectorXd mass;  ///< n
  Eigenpairs spectrum;   ///< derivatives across borders vanish; k as the options say, or less on a small surface
  Rows3 coefficients;    ///< k x 3: functions * coefficients are the smoothed coordinates
  Eigen::MatrixXf spin;  ///< 96 x n, spin_images()
  std::vector<double> to_border;  ///< n: along edges; infinite on a closed surface

  std::size_t n_vertices() const { return surface.vertices.size(); }
};

/// \pre connected, every vertex has a facet \param unit length of the common unit
PartialShape make_partial_shape(Surface<3> surface, double unit, const AlignmentOptions& options);

}  // namespace shellmatch
