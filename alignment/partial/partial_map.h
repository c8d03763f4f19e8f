#pragma once
/// \file
/// A map from a part to a whole by functional maps. After E. Rodola, L. Cosmo, M. M. Bronstein, A. Torsello and D.
/// Cremers, 'Partial functional correspondence', Computer Graphics Forum 36, 2017: functions of the whole up to some
/// eigenvalue, read on the part, are combinations of those of the part up to the same eigenvalue, of which there are
/// fewer by the share of the area.

#include <Eigen/Core>

#include "alignment/functional_map/nearest_features.h"
#include "alignment/options.h"
#include "alignment/spectrum/edge_graph.h"
#include "alignment/spectrum/laplacian.h"
#include "alignment/spectrum/spin_images.h"

#include <vector>

namespace shellmatch {

/// Radius of the spin images; nearer borders they lack what was cut away, so that it is less than that of whole
/// surfaces.
inline constexpr double part_spin_radius = 0.08;

/// Lengths are in a unit that part and whole share: the root of the area of the whole. n vertices, k eigenpairs.
struct PartialShape {
  Surface<3> surface;
  EdgeGraph graph;
  Eigen::VectorXd mass;  ///< n
  LaplacianEigenpairs
      spectrum;           ///< derivatives across borders vanish; k as the options say, or less on a small surface
  Rows3 coefficients;     ///< k x 3: functions * coefficients are the smoothed coordinates
  Eigen::MatrixXf spin;   ///< 96 x n, spin_images()
  Eigen::MatrixXf local;  ///< p x n: main components of those of the whole
  std::vector<double> to_border;  ///< n: along edges; infinite on a closed surface

  std::size_t n_vertices() const { return surface.vertices.size(); }
};

/// \pre connected, every vertex has a facet \param unit length of the common unit \param components of the whole's spin
/// images, 96 x p; empty: `local` is empty
PartialShape make_partial_shape(Surface<3> surface, double unit, const AlignmentOptions& options,
                                const Eigen::MatrixXf& components = {});

struct PartialWhole {
  PartialShape shape;
  Eigen::MatrixXf components;  ///< of its spin images
};
PartialWhole make_partial_whole(Surface<3> surface, double unit, const AlignmentOptions& options);

struct PartialMap {
  std::vector<Index> images;   ///< of all vertices of the part, vertices of the whole
  Features on_part, on_whole;  ///< a column for each vertex: what agrees at corresponding points
  /// Over the part, the less the nearer a border: relative difference of the functions, mean square difference of spin
  /// images, mean of (1 - n . n') / 2 over the normals of the whole and those that the part has after the map.
  double functions = 0, spin = 0, orientation = 0;

  double total() const { return functions + spin + orientation; }
  /// What tells right from wrong among maps of the same two surfaces, whatever the scale of the part, as
  /// MapScore::distinction().
  double order() const { return (functions + orientation) * spin; }
};

/// As margin_between() of maps between wholes; the maps differ where images are farther apart than `apart`.
double margin_between(const PartialShape& part, const PartialShape& whole, const PartialMap& first,
                      const PartialMap& other, double apart);

/// How a refinement goes.
struct PartialSchedule {
  int first;     ///< functions of the whole at first
  double share;  ///< functions of the part over those up to the same eigenvalue
};

/// Few functions mend rough images, and lose good ones, so that both schedules are worth a try. Near cuts functions of
/// the whole have derivatives across the border, which take more functions of the part.
inline constexpr PartialSchedule partial_schedules[] = {{12, 1.5}, {32, 2}};

/// What a refinement finds for samples of the part.
struct SampledMap {
  std::vector<Index> images;  ///< of the samples, before the last functional map, which is of these
  std::vector<Index> last_images;
  double share = 1;  ///< of the schedule
  double order = 0;  ///< that of a PartialMap, of the samples, and with normals of smoothed coordinates
};

/// Alternates nearest neighbours and functional maps with more and more functions, and normals and spin images beside
/// them. \param queries samples of the part, well spread, and \param images theirs on the whole \param samples
/// vertices of the whole, well spread, that are searched
SampledMap refine_partial_map(const PartialShape& part, const PartialShape& whole, const std::vector<Index>& queries,
                              std::vector<Index> images, const std::vector<Index>& samples,
                              const PartialSchedule& schedule);

/// The same map of all vertices.
PartialMap complete_map(const PartialShape& part, const PartialShape& whole, const std::vector<Index>& queries,
                        const SampledMap& map);

}  // namespace shellmatch
