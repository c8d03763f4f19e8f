#include "alignment/rigid/normalized_surface.h"

#include "base/error.h"
#include "geometry/surface/facet_point.h"
#include "geometry/surface/pseudonormals.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <utility>

namespace shellmatch {

namespace {

double area_of(const Surface<3>& surface) {
  const double area = surface_measure(surface);
  if (!(area > 0) || !std::isfinite(area)) throw_input_error("a surface without area cannot be aligned");
  return area;
}

}  // namespace

NormalizedSurface::NormalizedSurface(const Surface<3>& input) : surface_(input) {
  const double area = area_of(input);
  const auto corners = [&](std::size_t f) {
    const auto& [a, b, c] = surface_.facets[f];
    return std::array{surface_.vertices[a], surface_.vertices[b], surface_.vertices[c]};
  };
  for (std::size_t f = 0; f < input.facets.size(); ++f) {
    const auto [a, b, c] = corners(f);
    centre_ += facet_measure(input, static_cast<Index>(f)) / area * (a + b + c) / 3;
  }
  for (Vec<3>& x : surface_.vertices) x -= centre_;
  // The midpoints of the edges, a third of the area each, integrate quadratic functions exactly.
  Mat<3> moments = Mat<3>::Zero();
  double sum = 0;
  for (std::size_t f = 0; f < input.facets.size(); ++f) {
    const auto [a, b, c] = corners(f);
    const double share = facet_measure(surface_, static_cast<Index>(f)) / area;
    for (const Vec<3>& x : {Vec<3>((a + b) / 2), Vec<3>((b + c) / 2), Vec<3>((c + a) / 2)})
      moments += share / 3 * x * x.transpose();
    area_up_to_.push_back(sum += share);
  }
  radius_ = std::sqrt(moments.trace());
  for (Vec<3>& x : surface_.vertices) x /= radius_;
  axes_ = Eigen::SelfAdjointEigenSolver<Mat<3>>(moments).eigenvectors();
  if (axes_.determinant() < 0) axes_.col(0) *= -1;
  for (std::size_t f = 0; f < input.facets.size(); ++f)
    normals_.push_back(unit_or_zero<3>(facet_normal(surface_, static_cast<Index>(f))));
  tree_.emplace(surface_);
}

std::vector<SurfacePoint> NormalizedSurface::samples(std::size_t n) const {
  std::vector<SurfacePoint> samples;
  for (std::size_t k = 0; k < n; ++k) {
    const double at = (static_cast<double>(k) + 0.5) / static_cast<double>(n) * area_up_to_.back();
    const auto f =
        static_cast<std::size_t>(std::lower_bound(area_up_to_.begin(), area_up_to_.end(), at) - area_up_to_.begin());
    // Kronecker's sequence of the golden ratio's kind spreads the points over the facets' interiors.
    double u = std::fmod(0.5 + 0.7548776662466927 * static_cast<double>(k), 1.0),
           v = std::fmod(0.5 + 0.5698402909980532 * static_cast<double>(k), 1.0);
    if (u + v > 1) {
      u = 1 - u;
      v = 1 - v;
    }
    const auto& [a, b, c] = surface_.facets[f];
    samples.push_back(
        {(1 - u - v) * surface_.vertices[a] + u * surface_.vertices[b] + v * surface_.vertices[c], normals_[f]});
  }
  return samples;
}

SurfacePoint NormalizedSurface::nearest(const Vec<3>& x) const {
  const Index f = tree_->nearest(x);
  return {closest_point_on_facet<3>(surface_, f, x).point, normals_[static_cast<std::size_t>(f)]};
}

SampleCloud::SampleCloud(std::vector<SurfacePoint> samples)
    : samples_(std::move(samples)), points_(samples_.size(), 3) {
  for (std::size_t i = 0; i < samples_.size(); ++i)
    points_.row(static_cast<Eigen::Index>(i)) = samples_[i].point.transpose().array().cast<float>();
}

const SurfacePoint& SampleCloud::nearest(const Vec<3>& x) const {
  const Eigen::Array3f at = x.cast<float>();
  static thread_local Eigen::ArrayXf squares;
  squares = (points_.col(0) - at[0]).square() + (points_.col(1) - at[1]).square() + (points_.col(2) - at[2]).square();
  // Not minCoeff(&place), which Eigen does not vectorise.
  const auto least = std::find(squares.begin(), squares.end(), squares.minCoeff());
  return samples_[static_cast<std::size_t>(least - squares.begin())];
}

}  // namespace shellmatch
