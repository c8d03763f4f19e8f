#include "geometry/generate/outline.h"

#include <algorithm>
#include <random>

namespace shellmatch {

namespace {

Vec<2> on_circle(double angle) { return {std::cos(angle), std::sin(angle)}; }

// Samples the unit circle so that the images of the points are equally spaced along the outline.
Body<2> equally_spaced(std::function<Vec<2>(const Vec<2>&)> pose, double edge_length) {
  constexpr int n_fine = 20000;
  std::vector<double> length(n_fine + 1, 0.0);
  Vec<2> last = pose(on_circle(0));
  for (int i = 1; i <= n_fine; ++i) {
    const Vec<2> next = pose(on_circle(2 * M_PI * i / n_fine));
    length[i] = length[i - 1] + (next - last).norm();
    last = next;
  }
  const int n = std::max(16, static_cast<int>(std::lround(length.back() / edge_length)));
  Body<2> body{{}, std::move(pose)};
  for (int k = 0; k < n; ++k) {
    const double wanted = length.back() * k / n;
    const auto above = std::upper_bound(length.begin() + 1, length.end() - 1, wanted);
    const double share = (wanted - *(above - 1)) / (*above - *(above - 1));
    const double place = static_cast<double>(above - 1 - length.begin()) + share;
    body.rest.vertices.push_back(on_circle(2 * M_PI * place / n_fine));
    body.rest.facets.push_back({k, (k + 1) % n});
  }
  return body;
}

Mat<2> rotation(double degrees) {
  const Vec<2> u = on_circle(radians(degrees));
  return (Mat<2>() << u.x(), -u.y(), u.y(), u.x()).finished();
}

}  // namespace

Body<2> circle_body(const CircleOptions& options, double edge_length) {
  return ellipse_body({.semi_x = options.radius, .semi_y = options.radius}, edge_length);
}

Body<2> ellipse_body(const EllipseOptions& options, double edge_length) {
  const Mat<2> linear = rotation(options.turn) * Vec<2>(options.semi_x, options.semi_y).asDiagonal();
  return equally_spaced([linear](const Vec<2>& u) -> Vec<2> { return domain_centre<2>() + linear * u; }, edge_length);
}

Body<2> star_body(const StarOptions& options, double edge_length) {
  const Mat<2> turn = rotation(options.turn + 90);
  return equally_spaced(
      [options, turn](const Vec<2>& u) -> Vec<2> {
        // The exponential of a cosine makes points narrower than bays.
        const double wave = std::cos(options.points * std::atan2(u.y(), u.x()));
        return domain_centre<2>() + options.radius * (1 + options.depth * (std::exp(0.5 * wave) - 1.06)) * (turn * u);
      },
      edge_length);
}

Body<2> blob_body(const BlobOptions& options, double edge_length) {
  constexpr int n_waves = 5;
  std::mt19937 generator(static_cast<std::uint32_t>(options.individual));
  std::vector<double> phase(n_waves);
  for (double& p : phase) p = 2 * M_PI * (generator() / 4294967296.0);
  return equally_spaced(
      [options, phase](const Vec<2>& u) -> Vec<2> {
        const double angle = std::atan2(u.y(), u.x());
        double sum = 0, power = 0;
        for (int k = 0; k < n_waves; ++k) {
          sum += std::sin((k + 2) * angle + phase[k]) / (k + 1);
          power += 0.5 / ((k + 1) * (k + 1));
        }
        return domain_centre<2>() + options.radius * (1 + options.roughness / std::sqrt(power) * sum) * u;
      },
      edge_length);
}

Body<2> leaf_body(const LeafOptions& o, double edge_length) {
  return equally_spaced(
      [o](const Vec<2>& u) -> Vec<2> {
        // Angle from the tip, positive to the left; +-pi is the stalk.
        const double angle = std::atan2(-u.x(), u.y());
        // Lobes are spread over +-130 degrees and become shorter towards the stalk.
        const double step = radians(260) / (o.lobes - 1), sharpness = 1.76 * o.lobes;
        double lobe = 0;
        for (int k = 0; k < o.lobes; ++k) {
          const double at = (k - 0.5 * (o.lobes - 1)) * step;
          lobe += (0.78 + 0.22 * std::cos(at)) * std::exp(sharpness * (std::cos(angle - at) - 1));
        }
        const double whole = 0.72 + 0.2 * std::cos(angle);
        double r = (1 - o.depth) * whole + o.depth * 1.12 * lobe;
        // Teeth are a sine with steepened crests. A bay contains the stalk, where teeth and lobes vanish.
        const double bay = std::exp(14 * (std::cos(angle - M_PI) - 1));
        const double saw = std::sin(o.teeth * angle + 0.6 * std::sin(o.teeth * angle));
        r = (r + o.serration * saw * (1 - bay)) * (1 - 0.6 * bay);
        r *= 1 + o.asymmetry * std::sin(angle);
        const Vec<2> flat(-0.385 * r * std::sin(angle) / std::sqrt(o.slenderness),
                          0.385 * r * std::cos(angle) * std::sqrt(o.slenderness));
        // Maps the midrib to an arc of a circle. Distances along it are preserved, and cross lines remain
        // straight.
        const double curvature = radians(o.bend) / 0.6, turn = curvature * flat.y();
        const double along = std::abs(curvature) < 1e-9 ? flat.y() : std::sin(turn) / curvature;
        const double aside = std::abs(curvature) < 1e-9 ? 0 : (1 - std::cos(turn)) / curvature;
        return Vec<2>(0.5, 0.43) + Vec<2>(flat.x() * std::cos(turn) + aside, along - flat.x() * std::sin(turn));
      },
      edge_length);
}

}  // namespace shellmatch
