// Procrustes analysis: motions that were put on are found, and what must not change does not.
#include "geometry/statistics/procrustes.h"

#include "base/error.h"
#include "tests/geometry/statistics/families.h"

#include <gtest/gtest.h>
#include <Eigen/LU>

#include <cmath>
#include <limits>
#include <random>
#include <string>

namespace shellmatch {
namespace {

using testing::distance;
using testing::random_sets;
using testing::random_weights;

// A product of two reflections for each plane: proper, and of any angle.
template <int Dim>
Mat<Dim> random_rotation(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  Mat<Dim> rotation = Mat<Dim>::Identity();
  for (int k = 0; k < 2 * (Dim - 1); ++k) {
    Vec<Dim> v;
    for (double& x : v) x = normal(random);
    rotation = rotation * (Mat<Dim>::Identity() - 2 / v.squaredNorm() * v * v.transpose());
  }
  return rotation;
}

template <int Dim>
void move(PointSets& sets, const Mat<Dim>& matrix, const Vec<Dim>& shift, Eigen::Index set) {
  for (Eigen::Index p = 0; p < sets.n_points(); ++p) {
    auto x = sets.coordinates.col(set).segment<Dim>(Dim * p);
    x = (matrix * x + shift).eval();
  }
}

// Every shape by a motion of its own; with `scales` its size, too.
template <int Dim>
PointSets moved(PointSets sets, bool scales, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> size(0.3, 3), shift(-20, 20);
  for (Eigen::Index i = 0; i < sets.n_sets(); ++i) {
    const double scale = scales ? size(random) : 1;
    Vec<Dim> by;
    for (double& x : by) x = shift(random);
    move<Dim>(sets, scale * random_rotation<Dim>(random), by, i);
  }
  return sets;
}

// Shapes that vary about one of them.
PointSets similar_sets(int dimension, Eigen::Index n_points, Eigen::Index n_sets, double variation) {
  PointSets sets = random_sets(dimension, n_points, n_sets, 12);
  const Eigen::VectorXd base = random_sets(dimension, n_points, 1, 13).coordinates.col(0);
  sets.coordinates = (variation * sets.coordinates).colwise() + base;
  return sets;
}

double greatest_distance(const PointSets& a, const PointSets& b, const Eigen::VectorXd& weights) {
  double greatest = 0;
  for (Eigen::Index i = 0; i < a.n_sets(); ++i)
    greatest = std::max(greatest, distance(a.coordinates.col(i), b.coordinates.col(i), weights));
  return greatest;
}

double size_of(const Eigen::VectorXd& shape, const Eigen::VectorXd& weights, int dimension) {
  Eigen::VectorXd centre = Eigen::VectorXd::Zero(dimension);
  for (Eigen::Index p = 0; p < weights.size(); ++p) centre += weights[p] * shape.segment(dimension * p, dimension);
  return distance(shape, centre.replicate(weights.size(), 1), weights);
}

template <int Dim>
void finds_motions(ProcrustesKind kind) {
  const PointSets one = random_sets(Dim, 15, 1, 21, 2);
  const Eigen::VectorXd weights = random_weights(15, 22), base = one.coordinates.col(0);
  const PointSets copies{Dim, base.replicate(1, 9)};
  const AlignedSets aligned =
      procrustes(moved<Dim>(copies, kind == ProcrustesKind::similarity, 23), weights, base, kind);
  EXPECT_LE(greatest_distance(aligned.sets, copies, weights), 1e-13 * 20);
  EXPECT_LE(distance(aligned.mean, base, weights), 1e-13 * 20);
  EXPECT_LE(aligned.n_iterations, 3);
  EXPECT_NEAR(aligned.enlargement, 1, 1e-12);
}

TEST(Procrustes, FindsMotionsExactly) {
  finds_motions<2>(ProcrustesKind::rigid);
  finds_motions<3>(ProcrustesKind::rigid);
  finds_motions<2>(ProcrustesKind::similarity);
  finds_motions<3>(ProcrustesKind::similarity);
}

// Whatever motions were put on the shapes before, the result is the same.
template <int Dim>
void forgets_motions(ProcrustesKind kind) {
  const PointSets sets = similar_sets(Dim, 12, 8, 0.2);
  const Eigen::VectorXd weights = random_weights(12, 31), start = sets.coordinates.col(3);
  const AlignedSets a = procrustes(sets, weights, start, kind);
  const AlignedSets b = procrustes(moved<Dim>(sets, kind == ProcrustesKind::similarity, 32), weights, start, kind);
  EXPECT_LE(greatest_distance(a.sets, b.sets, weights), 1e-11);
  EXPECT_GE(greatest_distance(a.sets, sets, weights), 1e-3);
  EXPECT_LE(distance(a.mean, mean_of(a.sets), weights), 1e-14);
  EXPECT_LT(a.n_iterations, 60);
}

TEST(Procrustes, ForgetsMotions) {
  forgets_motions<2>(ProcrustesKind::rigid);
  forgets_motions<3>(ProcrustesKind::rigid);
  forgets_motions<2>(ProcrustesKind::similarity);
  forgets_motions<3>(ProcrustesKind::similarity);
}

// Another start is another frame: the same shapes, moved together, and with similarity of another size.
template <int Dim>
void start_is_a_frame(ProcrustesKind kind) {
  const PointSets sets = similar_sets(Dim, 12, 8, 0.2);
  const Eigen::VectorXd weights = random_weights(12, 31);
  PointSets starts{Dim, sets.coordinates.col(3)};
  const AlignedSets a = procrustes(sets, weights, starts.coordinates.col(0), kind);
  starts.coordinates.col(0) = sets.coordinates.col(6);
  starts = moved<Dim>(starts, true, 33);
  const Eigen::VectorXd start = starts.coordinates.col(0);
  const AlignedSets b = procrustes(sets, weights, start, kind);
  for (Eigen::Index i = 0; i < sets.n_sets(); ++i)
    for (Eigen::Index j = 0; j < sets.n_sets(); ++j) {
      const double before =
          distance(a.sets.coordinates.col(i), a.sets.coordinates.col(j), weights) / size_of(a.mean, weights, Dim);
      EXPECT_NEAR(
          distance(b.sets.coordinates.col(i), b.sets.coordinates.col(j), weights) / size_of(b.mean, weights, Dim),
          before, 1e-10);
    }
  // The mean is where the start is: aligning it there again changes nothing.
  const PointSets again = align_to_mean({Dim, b.mean}, weights, start, ProcrustesKind::rigid);
  EXPECT_LE(distance(again.coordinates.col(0), b.mean, weights), 1e-12 * 20);
  if (kind == ProcrustesKind::similarity) {
    EXPECT_NEAR(size_of(b.mean, weights, Dim), size_of(start, weights, Dim), 1e-12 * 20);
  } else {
    for (Eigen::Index i = 0; i < sets.n_sets(); ++i)
      EXPECT_NEAR(size_of(b.sets.coordinates.col(i), weights, Dim), size_of(sets.coordinates.col(i), weights, Dim),
                  1e-13 * 20);
  }
}

TEST(Procrustes, StartIsAFrame) {
  start_is_a_frame<2>(ProcrustesKind::rigid);
  start_is_a_frame<3>(ProcrustesKind::rigid);
  start_is_a_frame<2>(ProcrustesKind::similarity);
  start_is_a_frame<3>(ProcrustesKind::similarity);
}

double spread(const AlignedSets& aligned, const PointSets& sets, const Eigen::VectorXd& weights) {
  double sum = 0;
  for (Eigen::Index i = 0; i < sets.n_sets(); ++i)
    sum += std::pow(distance(sets.coordinates.col(i), aligned.mean, weights), 2);
  return sum;
}

// No small motion of a single shape brings it nearer to the mean.
template <int Dim>
void is_least(ProcrustesKind kind) {
  const PointSets sets = similar_sets(Dim, 12, 8, 0.3);
  const Eigen::VectorXd weights = random_weights(12, 41);
  const AlignedSets aligned = procrustes(sets, weights, sets.coordinates.col(0), kind);
  const double least = spread(aligned, aligned.sets, weights);
  std::mt19937_64 random(42);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 30; ++trial) {
    Mat<Dim> skew;
    for (int i = 0; i < Dim; ++i)
      for (int j = 0; j < Dim; ++j) skew(i, j) = normal(random);
    skew = (skew - skew.transpose()).eval();
    const Mat<Dim> one = Mat<Dim>::Identity(),
                   rotation = (one - 1e-3 * skew).inverse() * (one + 1e-3 * skew);  // Cayley
    Vec<Dim> shift;
    for (double& x : shift) x = 1e-3 * normal(random);
    PointSets disturbed = aligned.sets;
    move<Dim>(disturbed, rotation, shift, trial % 8);
    EXPECT_GT(spread(aligned, disturbed, weights), least);
  }
}

TEST(Procrustes, NoMotionBringsAShapeNearerToTheMean) {
  is_least<2>(ProcrustesKind::rigid);
  is_least<3>(ProcrustesKind::rigid);
}

// With similarity: of all scales with a mean of this size, those of the first eigenvector of the correlations between
// shapes of unit size have the least spread relative to the mean.
TEST(Procrustes, ScalesAreTheFirstEigenvector) {
  const PointSets sets = similar_sets(3, 12, 8, 0.3);
  const Eigen::VectorXd weights = random_weights(12, 41);
  const AlignedSets aligned = procrustes(sets, weights, sets.coordinates.col(0), ProcrustesKind::similarity);
  const Eigen::Index n = sets.n_sets();
  Eigen::VectorXd centre = Eigen::VectorXd::Zero(3), sizes(n);
  for (Eigen::Index p = 0; p < weights.size(); ++p) centre += weights[p] * aligned.mean.segment(3 * p, 3);
  const Eigen::VectorXd place = centre.replicate(weights.size(), 1);
  Eigen::MatrixXd units(aligned.mean.size(), n), correlations(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    sizes[i] = size_of(aligned.sets.coordinates.col(i), weights, 3);
    units.col(i) = (aligned.sets.coordinates.col(i) - place) / sizes[i];
  }
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j)
      correlations(i, j) = 1 - std::pow(distance(units.col(i), units.col(j), weights), 2) / 2;
  const Eigen::VectorXd image = correlations * sizes;
  const double value = image.dot(sizes) / sizes.squaredNorm();
  EXPECT_LE((image - value * sizes).norm(), 1e-9 * image.norm());
  EXPECT_GT(value, static_cast<double>(n) / 2);  // and no other eigenvector: the trace is n
  EXPECT_GT((sizes.array() / sizes.mean() - 1).abs().maxCoeff(), 1e-3);
}

template <int Dim>
void reflects_nothing() {
  const PointSets one = random_sets(Dim, 15, 1, 51);
  PointSets sets{Dim, one.coordinates.replicate(1, 2)};
  Mat<Dim> mirror = Mat<Dim>::Identity();
  mirror(0, 0) = -1;
  move<Dim>(sets, mirror, Vec<Dim>::Zero(), 1);
  const Eigen::VectorXd weights = uniform_weights(15);
  const PointSets aligned = align_to_mean(sets, weights, one.coordinates.col(0), ProcrustesKind::rigid);
  EXPECT_LE(distance(aligned.coordinates.col(0), one.coordinates.col(0), weights), 1e-13);
  EXPECT_GE(distance(aligned.coordinates.col(1), one.coordinates.col(0), weights), 0.1);
  // The map between the shape and its image is a rotation; found from the points by least squares.
  Mat<Dim> square = Mat<Dim>::Zero(), across = square;
  for (Eigen::Index p = 0; p < 15; ++p) {
    const Vec<Dim> x = sets.coordinates.col(1).segment<Dim>(Dim * p) - sets.coordinates.col(1).segment<Dim>(0);
    const Vec<Dim> y = aligned.coordinates.col(1).segment<Dim>(Dim * p) - aligned.coordinates.col(1).segment<Dim>(0);
    square += x * x.transpose();
    across += y * x.transpose();
  }
  EXPECT_NEAR((across * square.inverse()).determinant(), 1, 1e-10);
}

TEST(Procrustes, ReflectsNothing) {
  reflects_nothing<2>();
  reflects_nothing<3>();
}

TEST(Procrustes, FurtherShapesComeToWhereTheyWerePut) {
  for (const ProcrustesKind kind : {ProcrustesKind::rigid, ProcrustesKind::similarity, ProcrustesKind::none}) {
    const PointSets sets = moved<3>(similar_sets(3, 12, 8, 0.2), true, 61);
    const Eigen::VectorXd weights = random_weights(12, 62);
    const AlignedSets aligned = procrustes(sets, weights, sets.coordinates.col(0), kind);
    const PointSets again = align_to_mean(sets, weights, aligned.mean, kind, aligned.enlargement);
    EXPECT_LE(greatest_distance(again, aligned.sets, weights), 1e-10);
    EXPECT_EQ(aligned.sets.coordinates == sets.coordinates, kind == ProcrustesKind::none);
    EXPECT_EQ(aligned.enlargement > 1 + 1e-4, kind == ProcrustesKind::similarity);
  }
}

TEST(Procrustes, OneShapeComesToTheStart) {
  const PointSets start = random_sets(3, 9, 1, 71);
  const Eigen::VectorXd weights = uniform_weights(9);
  const AlignedSets aligned =
      procrustes(moved<3>(start, false, 72), weights, start.coordinates.col(0), ProcrustesKind::rigid);
  EXPECT_LE(greatest_distance(aligned.sets, start, weights), 1e-12);
}

// What the points do not determine is chosen, and nothing else suffers.
TEST(Procrustes, OfPointsOnALine) {
  PointSets sets{3, Eigen::MatrixXd(9, 2)};
  sets.coordinates.col(0) << 0, 0, 0, 1, 0, 0, 3, 0, 0;
  sets.coordinates.col(1) << 5, 5, 5, 5, 6, 5, 5, 8, 5;
  const Eigen::VectorXd weights = uniform_weights(3);
  const AlignedSets aligned = procrustes(sets, weights, sets.coordinates.col(0), ProcrustesKind::rigid);
  EXPECT_LE(distance(aligned.sets.coordinates.col(1), sets.coordinates.col(0), weights), 1e-12);
}

std::string error_of_procrustes(const PointSets& sets, const Eigen::VectorXd& start,
                                ProcrustesKind kind = ProcrustesKind::rigid) {
  try {
    procrustes(sets, uniform_weights(sets.n_points()), start, kind);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no InputError";
}

TEST(Procrustes, SaysWhatIsWrong) {
  PointSets sets = random_sets(3, 5, 4, 81, 100);
  const Eigen::VectorXd start = sets.coordinates.col(0);
  sets.coordinates.col(2) = Eigen::Vector3d(0.1, 100 / 3.0, 77).replicate(5, 1);
  EXPECT_NE(error_of_procrustes(sets, start).find("shape 2 (counted from 0): its points coincide"), std::string::npos);
  EXPECT_EQ(error_of_procrustes(sets, start, ProcrustesKind::none), "no InputError");
  EXPECT_NE(error_of_procrustes(sets, sets.coordinates.col(2)).find("shape to align to: its points coincide"),
            std::string::npos);
  EXPECT_NE(error_of_procrustes(sets, Eigen::VectorXd::Zero(3)).find("3 coordinates"), std::string::npos);
  EXPECT_NE(error_of_procrustes(sets, start * std::numeric_limits<double>::quiet_NaN()).find("not finite"),
            std::string::npos);
  EXPECT_NE(error_of_procrustes(random_sets(3, 1, 2, 82), Eigen::Vector3d(1, 2, 3)).find("coincide"),
            std::string::npos);
  sets.coordinates(3, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(error_of_procrustes(sets, start).find("shape 1, point 1"), std::string::npos);
}

}  // namespace
}  // namespace shellmatch
