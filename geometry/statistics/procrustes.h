#pragma once
/// \file
/// Generalised Procrustes analysis: what position, direction and, if wanted, size add to the differences of shapes is
/// taken out.

#include "base/options.h"
#include "geometry/statistics/point_sets.h"

namespace shellmatch {

enum class ProcrustesKind { none, rigid, similarity };
template <>
struct EnumNames<ProcrustesKind> {
  static constexpr std::pair<ProcrustesKind, std::string_view> names[] = {
      {ProcrustesKind::none, "none"}, {ProcrustesKind::rigid, "rigid"}, {ProcrustesKind::similarity, "similarity"}};
};

struct AlignedSets {
  PointSets sets;
  Eigen::VectorXd mean;  ///< of the aligned sets
  int n_iterations = 0;
  /// With similarity, by what aligned sets are larger than where they fit the mean best: a shape that is more unlike
  /// the mean is fitted smaller, and the mean of all is to keep its size. 1 otherwise.
  double enlargement = 1;
};

/// Moves every shape onto the mean of all, in turn with the mean, until the mean converges (Gower 1975):
///     sum_i |s_i R_i (x_i - c_i) - mean|^2
/// becomes least, in the inner product of the weights, over rotations R_i and, with similarity, scales s_i for a mean
/// of given size. Proper rotations only. The mean stays where, and with similarity as large as, `start` is; without
/// `similarity` sizes are kept. A direction that nothing determines, as that about the line of points on one line, is
/// an arbitrary one, the same in each call. It has converged where it changes by less than 1e-12 of its size;
/// n_iterations is 200 where it never did. \param weights of the points, sum 1 \param start of the iteration, dimension
/// * V coordinates; the frame of the result \throws InputError for a shape whose points coincide, and as
/// check_point_sets()
AlignedSets procrustes(PointSets sets, const Eigen::VectorXd& weights, const Eigen::VectorXd& start,
                       ProcrustesKind kind);

/// Moves further shapes onto the mean of an analysis. Those that it was made from come to where they were put.
/// \param enlargement of the analysis \throws InputError as procrustes()
PointSets align_to_mean(PointSets sets, const Eigen::VectorXd& weights, const Eigen::VectorXd& mean,
                        ProcrustesKind kind, double enlargement = 1);

}  // namespace shellmatch
