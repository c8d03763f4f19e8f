#include "tests/geometry/surface/test_surfaces.h"

#include "geometry/io/input_file.h"
#include "geometry/mesh_text/read_mesh_formats.h"
#include "tests/support/folders.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>

namespace shellmatch::test {

Surface<3> unit_sphere(int level) {
  Surface<3> s;
  s.vertices = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  s.facets = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int l = 0; l < level; ++l) {
    std::map<std::pair<Index, Index>, Index> middles;
    const auto middle = [&](Index a, Index b) {
      const auto [place, is_new] = middles.try_emplace(std::minmax(a, b), static_cast<Index>(s.vertices.size()));
      if (is_new) s.vertices.push_back((s.vertices[a] + s.vertices[b]).normalized());
      return place->second;
    };
    std::vector<std::array<Index, 3>> facets;
    for (const auto& [a, b, c] : s.facets) {
      const Index ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      for (const std::array<Index, 3>& f : {std::array{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
        facets.push_back(f);
    }
    s.facets = std::move(facets);
  }
  return s;
}

Surface<3> torus(double core, double tube, int n_core, int n_tube) {
  Surface<3> s;
  for (int i = 0; i < n_core; ++i)
    for (int j = 0; j < n_tube; ++j) {
      const double u = 2 * std::numbers::pi * i / n_core, v = 2 * std::numbers::pi * j / n_tube;
      const double r = core + tube * std::cos(v);
      s.vertices.emplace_back(r * std::cos(u), r * std::sin(u), tube * std::sin(v));
    }
  const auto vertex = [&](int i, int j) { return (i % n_core) * n_tube + j % n_tube; };
  for (int i = 0; i < n_core; ++i)
    for (int j = 0; j < n_tube; ++j) {
      s.facets.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      s.facets.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  return s;
}

Surface<3> box(const Vec<3>& min, const Vec<3>& max) {
  Surface<3> s;
  for (int corner = 0; corner < 8; ++corner) {
    Vec<3> x = min;
    for (int i = 0; i < 3; ++i)
      if (corner >> i & 1) x[i] = max[i];
    s.vertices.push_back(x);
  }
  s.facets = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
              {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return s;
}

Surface<3> wedge_with_flat_triangle(double thickness) {
  Surface<3> s;
  s.vertices = {{0, 0, 0}, {1, 0, 0}, {0.5, 1, thickness}, {0.5, 1, -thickness}, {0.5, 0, 0}};
  // Above the sharp edge (0, 1) two triangles end at its middle 4, below it a single one does not.
  s.facets = {{0, 4, 2}, {4, 1, 2}, {1, 0, 3}, {0, 2, 3}, {2, 1, 3}, {0, 1, 4}};
  return s;
}

Surface<2> polygon(int n, const std::function<double(double)>& radius) {
  Surface<2> s;
  for (int i = 0; i < n; ++i) {
    const double t = 2 * std::numbers::pi * i / n;
    s.vertices.push_back(radius(t) * Vec<2>(std::cos(t), std::sin(t)));
    s.facets.push_back({i, (i + 1) % n});
  }
  return s;
}

std::optional<Surface<3>> data_surface(const std::string& file) {
  const std::filesystem::path path = data_folder() / file;
  if (!std::filesystem::exists(path)) return std::nullopt;
  const std::string bytes = InputFile(path.string()).read();
  const auto original = (path.extension() == ".ply" ? read_ply : read_off)(path.string(), bytes).shape;
  Surface<3> s;
  s.vertices = original.vertices;
  for (const auto& p : original.polygons)
    for (std::size_t k = 2; k < p.size(); ++k) s.facets.push_back({p[0], p[k - 1], p[k]});
  const Box<3> b = bounding_box(s.vertices);
  return mapped<3>(std::move(s), [&](const Vec<3>& x) { return Vec<3>((x - b.min) / (b.max - b.min).maxCoeff()); });
}

}  // namespace shellmatch::test
