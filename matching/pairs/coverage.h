#pragma once
/// \file
/// Coverage: the match term asks every point of phi(M1) to lie on M2, and no other term asks every point of M2 to be
/// reached. Pairs of closest points ask for both, point to plane as in the iterative closest point method of Chen and
/// Medioni (1992).

#include "energies/elements/band_mask.h"
#include "energies/pairs/point_pairs.h"
#include "geometry/distance/signed_distance.h"
#include "geometry/surface/surface.h"
#include "grid/octree/octree.h"
#include "matching/experiment/pair_options.h"
#include "matching/level/level_energy.h"
#include "matching/level/observed_mask.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace shellmatch {

template <int Dim>
struct SurfaceSample {
  Index vertex;
  Vec<Dim> x;
  Vec<Dim> normal;  ///< of length 1: the mean over the facets around, by their area (length)
  double area;      ///< that it stands for (length)
};

/// Samples of the vertices that have an area and a normal and for which `contains` holds: all or, where there are more,
/// at most `most`, each of which stands for a multiple of total area / most. They are taken along a Morton curve, which
/// spreads them evenly.
template <int Dim>
std::vector<SurfaceSample<Dim>> sample_vertices(const Surface<Dim>& surface, std::size_t most,
                                                const std::function<bool(const Vec<Dim>&)>& contains);

template <int Dim>
class Coverage {
 public:
  /// Samples at most options.samples vertices of each shape, where it has data. Facets larger than samples are apart,
  /// and than cells, are subdivided before. \param reference, template_shape in the unit domain; the latter must
  /// outlive this object \param side of the finest cells of the last level
  Coverage(const Surface<Dim>& reference, const SignedDistance<Dim>& template_shape, double side,
           const CoverageOptions& options, const ObservedPair<Dim>& observed = {});

  /// Pairs for the present phi, weighted by the area that each sample stands for: each sample of M2 with the nearest
  /// point of phi(M1), and each of M1 with the point of M2 nearest to its image. They pull the point of M1 into the
  /// plane that touches M2 at the other point, or to that point itself where a sample of M2 is farther than
  /// options.point_distance. No pair is made where the nearest part of the other shape faces away, which belongs to
  /// another limb or to the other side of this one. On a grid coarser than that of the last level,
  /// options.coarse_tolerance counts where it is larger than options.tolerance. \param mask null where both shapes have
  /// data everywhere; else another factor on the weights, so that points near the edge of a gap,
  ///   whose counterpart may lie beyond it, weigh little here as in the match term
  PointPairs<Dim> pairs(const Octree<Dim>& grid, const std::vector<Vec<Dim>>& phi,
                        const BandMask<Dim>* mask = nullptr) const;

 private:
  /// \param normals at the vertices of the deformed reference
  void add_from_template(const Surface<Dim>& deformed, const std::vector<Vec<Dim>>& normals, const Octree<Dim>& grid,
                         const std::vector<Vec<Dim>>& phi, std::vector<PointPair<Dim>>& found) const;
  void add_from_reference(const Surface<Dim>& deformed, const std::vector<Vec<Dim>>& normals,
                          std::vector<PointPair<Dim>>& found) const;

  const SignedDistance<Dim>* template_;
  CoverageOptions options_;
  Surface<Dim> reference_;
  std::vector<SurfaceSample<Dim>> on_reference_, on_template_;
  double side_;       ///< of the finest cells of the last level
  double tolerance_;  ///< sides of the domain
};

/// The terms of points that a matching has on its levels: pairs that are known, and coverage, whose pairs follow phi.
template <int Dim>
class PointTerms {
 public:
  /// \param options, template_shape outlive this object
  PointTerms(std::vector<PairSet<Dim>> known, const Surface<Dim>& reference, const SignedDistance<Dim>& template_shape,
             const ExperimentOptions& options, const ObservedPair<Dim>& observed = {});

  /// Adds them to the energy of one level. \pre this object outlives the energy
  void add_to(LevelEnergy<Dim>& level) const;

  const std::vector<PairSet<Dim>>& known() const { return known_; }

 private:
  const ExperimentOptions* options_;
  std::vector<PairSet<Dim>> known_;
  std::optional<Coverage<Dim>> coverage_;  ///< where it acts on a level
};

}  // namespace shellmatch
