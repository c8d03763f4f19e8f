#pragma once
/// \file
/// A surface with what spectral matching needs of it.

#include "alignment/options.h"
#include "alignment/spectrum/laplacian.h"
#include "alignment/spectrum/spin_images.h"
#include "alignment/spectrum/surface_tips.h"

#include <array>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

namespace shellmatch {

/// A connected surface of area 1 with its centre of mass in the origin. n vertices, k eigenpairs.
struct SpectralShape {
  Surface<3> surface;
  EdgeGraph graph;
  Eigen::VectorXd mass;          ///< n
  Eigen::VectorXd values;        ///< k eigenvalues
  Eigen::MatrixXd functions;     ///< n x k
  Rows3 coefficients;            ///< k x 3: functions * coefficients are the smoothed coordinates
  Rows3 normals;                 ///< n x 3, of unit length
  Eigen::MatrixXd signature;     ///< n x m, wave_kernel_signature()
  Eigen::MatrixXf spin;          ///< 192 x n, spin_images()
  std::vector<Index> samples;    ///< farthest point samples, n_spectral_samples of them or all vertices
  std::vector<SurfaceTip> tips;  ///< ends of limbs
  Vec<3> centre;                 ///< of the input
  double root_area;              ///< of the input
  double handedness = 1;         ///< -1 where it is the mirrored input

  std::size_t n_vertices() const { return surface.vertices.size(); }
  Vec<3> in_input_coordinates(const Vec<3>& x) const {
    return centre + root_area * Vec<3>(handedness * x[0], x[1], x[2]);
  }
};

/// Number of samples in SpectralShape, where there are as many vertices.
inline constexpr std::size_t n_spectral_samples = 1500;

/// Moves and scales the surface, and computes the rest. \pre connected, every vertex has a facet
SpectralShape make_spectral_shape(Surface<3> surface, const AlignmentOptions& options);

/// The shape mirrored in x, oriented outward again.
SpectralShape mirrored_shape(SpectralShape shape);

/// The wave kernel signature at every vertex (n x m), a descriptor that does not depend on the pose: Aubry, Schlickewei
/// and Cremers, 'The wave kernel signature', ICCV workshops 2011. Each column is scaled to mean 1 over the surface.
Eigen::MatrixXd wave_kernel_signature(const LaplacianEigenpairs& pairs, const Eigen::VectorXd& mass, int n_energies);

/// Points or vectors in single precision, one in each column, whose fourth component is 0.
using Columns4 = Eigen::Matrix<float, 4, Eigen::Dynamic>;

struct SmoothedSurface {
  Columns4 coordinates, normals;  ///< of all vertices; normals as vertex_normals() has them
};

/// The smoothed copies of a shape, each computed once, by whoever asks first. Safe for parallel use; copies share
/// the data. \pre the shape outlives them
class SmoothedSurfaces {
 public:
  SmoothedSurfaces() = default;
  /// \param n_functions at most those of the shape
  SmoothedSurfaces(const SpectralShape& shape, int n_functions);

  /// \pre 0 < k <= n_functions
  const SmoothedSurface& with(int k) const;
  /// The surface whose coordinates are these combinations of the first functions. \param coefficients k x 3
  /// \param facets around the vertices whose normals are wanted
  SmoothedSurface combined(const Rows3& coefficients, std::span<const std::array<Index, 3>> facets) const;

 private:
  struct Entry {
    std::once_flag is_known;
    SmoothedSurface surface;
  };
  struct Data {
    Eigen::MatrixXf functions;  ///< n x k
    std::vector<Entry> entries;
  };
  const SpectralShape* shape_ = nullptr;
  std::shared_ptr<Data> data_;
};

}  // namespace shellmatch
