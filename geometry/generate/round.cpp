#include "geometry/generate/round.h"

#include "base/error.h"

#include <algorithm>
#include <map>

namespace shellmatch {

namespace {

// The twelve corners (0, +-1, +-golden ratio) and their cyclic shifts, and the twenty faces: all triples at
// distance 2.
Surface<3> icosahedron() {
  Surface<3> s;
  const double g = (1 + std::sqrt(5.0)) / 2;
  for (int axis = 0; axis < 3; ++axis)
    for (const double a : {-1.0, 1.0})
      for (const double b : {-g, g}) {
        Vec<3> x = Vec<3>::Zero();
        x[(axis + 1) % 3] = a;
        x[(axis + 2) % 3] = b;
        s.vertices.push_back(x);
      }
  const auto near = [&](int i, int j) { return (s.vertices[i] - s.vertices[j]).norm() < 2.1; };
  const auto triple = [&](int i, int j, int k) {
    Mat<3> m;
    m << s.vertices[i], s.vertices[j], s.vertices[k];
    const double volume = m(0, 0) * (m(1, 1) * m(2, 2) - m(1, 2) * m(2, 1)) -
                          m(0, 1) * (m(1, 0) * m(2, 2) - m(1, 2) * m(2, 0)) +
                          m(0, 2) * (m(1, 0) * m(2, 1) - m(1, 1) * m(2, 0));
    return volume;
  };
  for (Index i = 0; i < 12; ++i)
    for (Index j = i + 1; j < 12; ++j)
      for (Index k = j + 1; k < 12; ++k)
        if (near(i, j) && near(j, k) && near(k, i))
          s.facets.push_back(triple(i, j, k) > 0 ? std::array{i, j, k} : std::array{i, k, j});
  return s;
}

int frequency_for(double radius, double edge_length) {
  // An edge of the icosahedron in the unit sphere has the length 1.0515; projection stretches it by
  // about 1.1.
  return std::max(2, static_cast<int>(std::lround(1.15 * radius / edge_length)));
}

}  // namespace

Surface<3> geodesic_sphere(int frequency) {
  const Surface<3> coarse = icosahedron();
  Surface<3> s;
  // A vertex is identified by its integer weights on the corners of the icosahedron, of which at most three
  // are not zero.
  std::map<std::array<int, 6>, Index> known;
  const auto vertex = [&](const std::array<Index, 3>& corner, const std::array<int, 3>& weight) {
    std::array<std::pair<int, int>, 3> parts;
    for (int k = 0; k < 3; ++k) parts[k] = weight[k] > 0 ? std::pair(corner[k], weight[k]) : std::pair(no_index, 0);
    std::sort(parts.begin(), parts.end());
    std::array<int, 6> key;
    Vec<3> x = Vec<3>::Zero();
    for (int k = 0; k < 3; ++k) {
      key[2 * k] = parts[k].first;
      key[2 * k + 1] = parts[k].second;
      if (parts[k].second > 0) x += parts[k].second * coarse.vertices[parts[k].first];
    }
    const auto [entry, is_new] = known.try_emplace(key, static_cast<Index>(s.vertices.size()));
    if (is_new) s.vertices.push_back(x.normalized());
    return entry->second;
  };
  for (const auto& face : coarse.facets)
    for (int i = 0; i < frequency; ++i)
      for (int j = 0; i + j < frequency; ++j) {
        const int k = frequency - i - j;
        s.facets.push_back({vertex(face, {k, i, j}), vertex(face, {k - 1, i + 1, j}), vertex(face, {k - 1, i, j + 1})});
        if (k > 1)
          s.facets.push_back(
              {vertex(face, {k - 1, i + 1, j}), vertex(face, {k - 2, i + 1, j + 1}), vertex(face, {k - 1, i, j + 1})});
      }
  return s;
}

Body<3> sphere_body(const SphereOptions& options, double edge_length) {
  const double r = options.radius;
  return ellipsoid_body({.semi_x = r, .semi_y = r, .semi_z = r}, edge_length);
}

Body<3> ellipsoid_body(const EllipsoidOptions& options, double edge_length) {
  const Vec<3> semi(options.semi_x, options.semi_y, options.semi_z);
  return {geodesic_sphere(frequency_for(semi.mean(), edge_length)),
          [semi](const Vec<3>& u) -> Vec<3> { return domain_centre<3>() + semi.cwiseProduct(u); }};
}

Body<3> torus_body(const TorusOptions& options, double edge_length) {
  const double major = options.major_radius, minor = options.minor_radius;
  if (minor >= 0.95 * major)
    throw_input_error("torus: minor_radius {:g} must be less than 0.95 times major_radius {:g}", minor, major);
  const int n_long = std::max(8, static_cast<int>(std::lround(2 * M_PI * major / edge_length)));
  // Even, because every second row is shifted by half a step.
  const int n_short = 2 * std::max(3, static_cast<int>(std::lround(M_PI * minor / edge_length / 0.87)));
  Surface<3> rest;
  for (int j = 0; j < n_short; ++j)
    for (int i = 0; i < n_long; ++i) {
      const double angle = 2 * M_PI * (i + (j % 2) * 0.5) / n_long, turn = 2 * M_PI * j / n_short;
      const double rho = 1 + 0.5 * std::cos(turn);
      rest.vertices.emplace_back(rho * std::cos(angle), rho * std::sin(angle), 0.5 * std::sin(turn));
    }
  for (int j = 0; j < n_short; ++j)
    for (int i = 0; i < n_long; ++i) {
      const auto at = [&](int column, int row) { return static_cast<Index>(row % n_short * n_long + column % n_long); };
      const Index a = at(i, j), b = at(i + 1, j), c = at(i, j + 1), d = at(i + 1, j + 1);
      if (j % 2 == 0) {
        rest.facets.push_back({a, b, c});
        rest.facets.push_back({b, d, c});
      } else {
        rest.facets.push_back({a, b, d});
        rest.facets.push_back({a, d, c});
      }
    }
  return {std::move(rest), [major, minor](const Vec<3>& x) -> Vec<3> {
            const double rho = std::hypot(x.x(), x.y());
            const double cosine = 2 * (rho - 1), sine = 2 * x.z(), scale = (major + minor * cosine) / rho;
            return domain_centre<3>() + Vec<3>(scale * x.x(), scale * x.y(), minor * sine);
          }};
}

}  // namespace shellmatch
