#pragma once
/// \file
/// A surface smoothed to its first eigenfunctions, for as many of them as is asked for.

#include "alignment/spectrum/spectral_shape.h"

#include <array>
#include <memory>
#include <mutex>
#include <vector>

namespace shellmatch {

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
