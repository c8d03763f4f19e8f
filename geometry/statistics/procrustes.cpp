#include "geometry/statistics/procrustes.h"

#include "base/decompositions.h"
#include "base/error.h"
#include "base/parallel.h"

#include <Eigen/LU>

#include <cmath>
#include <utility>
#include <vector>

namespace shellmatch {

namespace {

// The proper rotation R for which the trace of R^T c is greatest. W. Kabsch, Acta Cryst. A34, 1978; S. Umeyama, IEEE
// PAMI 13(4), 1991.
Mat<3> best_rotation(const Mat<3>& c) {
  const Svd<Mat<3>> svd = jacobi_svd(c);
  const Mat<3>&u = svd.u, &v = svd.v;
  Mat<3> rotation = u.leftCols<2>() * v.leftCols<2>().transpose();
  rotation += (u.determinant() * v.determinant() < 0 ? -1 : 1) * u.col(2) * v.col(2).transpose();
  return rotation;
}

Mat<2> best_rotation(const Mat<2>& c) {
  const double x = c(0, 0) + c(1, 1), y = c(1, 0) - c(0, 1), length = std::hypot(x, y);
  if (length == 0) return Mat<2>::Identity();  // all directions are equally good
  return (Mat<2>() << x, -y, y, x).finished() / length;
}

template <int Dim>
class Procrustes {
 public:
  using Points = Eigen::Map<Eigen::Matrix<double, Dim, Eigen::Dynamic>>;
  using ConstPoints = Eigen::Map<const Eigen::Matrix<double, Dim, Eigen::Dynamic>>;

  Procrustes(PointSets& sets, const Eigen::VectorXd& weights, const Eigen::VectorXd& start, ProcrustesKind kind)
      : sets_(sets),
        weights_(weights),
        start_(start.data(), Dim, sets.n_points()),
        scales_(kind == ProcrustesKind::similarity),
        poses_(static_cast<std::size_t>(sets.n_sets())),
        mean_(start_) {
    place_ = centroid(start_);
    mean_.colwise() -= place_;
    size_ = size_of(mean_, Vec<Dim>::Zero());
    if (!(size_ > rounding_of({Dim, start})))
      throw_input_error("the shape to align to: its points coincide, so that it has no direction");
    const double rounding = rounding_of(sets);
    parallel_for(
        poses_.size(),
        [&](std::size_t i) {
          Pose& pose = poses_[i];
          pose.centre = centroid(shape(i));
          pose.size = size_of(shape(i), pose.centre);
          if (!(pose.size > rounding))
            throw_input_error(
                "shape {} (counted from 0): its points coincide, so that it has no direction; leave it out", i);
        },
        1);
  }

  int iterate() {
    constexpr int max_iterations = 200;
    constexpr double tolerance = 1e-12;
    for (int iteration = 1; iteration <= max_iterations; ++iteration) {
      fit_poses();
      if (update_mean() <= tolerance * size_) return iteration;
    }
    return max_iterations;
  }

  void fit_poses() {
    parallel_for(
        poses_.size(),
        [&](std::size_t i) {
          Pose& pose = poses_[i];
          const Mat<Dim> c = correlation(mean_, shape(i), pose.centre);
          pose.rotation = best_rotation(c);
          if (scales_) pose.scale = pose.rotation.cwiseProduct(c).sum() / (pose.size * pose.size);
        },
        1);
  }

  // Turns everything so that the mean has the direction of the start.
  void return_to_start() {
    const Mat<Dim> back = best_rotation(correlation(mean_, start_, place_)).transpose();
    for (Pose& pose : poses_) pose.rotation = back * pose.rotation;
  }

  void move_sets(double enlargement) {
    parallel_for(
        poses_.size(),
        [&](std::size_t i) {
          const Pose& pose = poses_[i];
          const Mat<Dim> turn = enlargement * pose.scale * pose.rotation;
          Points points = shape(i);
          for (Eigen::Index p = 0; p < points.cols(); ++p)
            points.col(p) = turn * (points.col(p) - pose.centre) + place_;
        },
        1);
  }

  double enlargement() const { return enlargement_; }

 private:
  struct Pose {
    Vec<Dim> centre = Vec<Dim>::Zero();
    Mat<Dim> rotation = Mat<Dim>::Identity();
    double size = 0, scale = 1;
  };

  Points shape(std::size_t i) {
    return {sets_.coordinates.col(static_cast<Eigen::Index>(i)).data(), Dim, sets_.n_points()};
  }

  // Loops of their own, as Eigen's products would take long to compile.
  template <class Some>
  Vec<Dim> centroid(const Some& points) const {
    Vec<Dim> sum = Vec<Dim>::Zero();
    for (Eigen::Index p = 0; p < points.cols(); ++p) sum += weights_[p] * points.col(p);
    return sum;
  }

  template <class Some>
  double size_of(const Some& points, const Vec<Dim>& centre) const {
    double sum = 0;
    for (Eigen::Index p = 0; p < points.cols(); ++p) sum += weights_[p] * (points.col(p) - centre).squaredNorm();
    return std::sqrt(sum);
  }

  // Sum of w a (b - centre)^T over the points.
  template <class A, class B>
  Mat<Dim> correlation(const A& a, const B& b, const Vec<Dim>& centre) const {
    Mat<Dim> sum = Mat<Dim>::Zero();
    for (Eigen::Index p = 0; p < b.cols(); ++p) {
      const Vec<Dim> from = weights_[p] * a.col(p), to = b.col(p) - centre;
      for (int k = 0; k < Dim; ++k) sum.col(k) += to[k] * from;
    }
    return sum;
  }

  // Returns by how much the mean has changed, as a root mean square.
  double update_mean() {
    Eigen::Matrix<double, Dim, Eigen::Dynamic> change = mean_;
    const double n = static_cast<double>(poses_.size());
    parallel_chunks(static_cast<std::size_t>(mean_.cols()), 256, [&](const Chunk& c) {
      const auto begin = static_cast<Eigen::Index>(c.begin), end = static_cast<Eigen::Index>(c.end);
      mean_.middleCols(begin, end - begin).setZero();
      for (std::size_t i = 0; i < poses_.size(); ++i) {
        const Mat<Dim> turn = poses_[i].scale / n * poses_[i].rotation;
        const Points x = shape(i);
        for (Eigen::Index p = begin; p < end; ++p) mean_.col(p) += turn * (x.col(p) - poses_[i].centre);
      }
    });
    if (scales_) {
      enlargement_ = size_ / size_of(mean_, Vec<Dim>::Zero());
      mean_ *= enlargement_;
    }
    change -= mean_;
    return size_of(change, Vec<Dim>::Zero());
  }

  PointSets& sets_;
  const Eigen::VectorXd& weights_;
  ConstPoints start_;
  bool scales_;
  std::vector<Pose> poses_;
  Eigen::Matrix<double, Dim, Eigen::Dynamic> mean_;  // about the origin
  Vec<Dim> place_;                                   // where its centroid is in the result
  double size_ = 0, enlargement_ = 1;
};

template <int Dim>
void align(AlignedSets& result, const Eigen::VectorXd& weights, const Eigen::VectorXd& start, ProcrustesKind kind) {
  Procrustes<Dim> analysis(result.sets, weights, start, kind);
  result.n_iterations = analysis.iterate();
  result.enlargement = analysis.enlargement();
  analysis.return_to_start();
  analysis.move_sets(result.enlargement);
}

template <int Dim>
void fit_to(PointSets& sets, const Eigen::VectorXd& weights, const Eigen::VectorXd& mean, ProcrustesKind kind,
            double enlargement) {
  Procrustes<Dim> analysis(sets, weights, mean, kind);
  analysis.fit_poses();
  analysis.move_sets(enlargement);
}

void check_start(const PointSets& sets, const Eigen::VectorXd& weights, const Eigen::VectorXd& start) {
  check_point_sets(sets, weights);
  if (start.size() != sets.coordinates.rows())
    throw_input_error("the shape to align to has {} coordinates, the shapes have {}", start.size(),
                      sets.coordinates.rows());
  if (!start.allFinite()) throw_input_error("the shape to align to: a point is not finite");
}

}  // namespace

AlignedSets procrustes(PointSets sets, const Eigen::VectorXd& weights, const Eigen::VectorXd& start,
                       ProcrustesKind kind) {
  check_start(sets, weights, start);
  AlignedSets result;
  result.sets = std::move(sets);
  if (kind != ProcrustesKind::none)
    result.sets.dimension == 2 ? align<2>(result, weights, start, kind) : align<3>(result, weights, start, kind);
  result.mean = mean_of(result.sets);
  return result;
}

PointSets align_to_mean(PointSets sets, const Eigen::VectorXd& weights, const Eigen::VectorXd& mean,
                        ProcrustesKind kind, double enlargement) {
  check_start(sets, weights, mean);
  if (kind != ProcrustesKind::none)
    sets.dimension == 2 ? fit_to<2>(sets, weights, mean, kind, enlargement)
                        : fit_to<3>(sets, weights, mean, kind, enlargement);
  return sets;
}

}  // namespace shellmatch
