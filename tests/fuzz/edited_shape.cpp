#include "tests/fuzz/edited_shape.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace shellmatch::fuzz {

namespace {

constexpr int most_edits = 60;
constexpr std::size_t most_vertices = 300, most_polygons = 400;

class Bytes {
 public:
  explicit Bytes(std::string_view bytes) : rest_(bytes) {}
  bool any() const { return !rest_.empty(); }
  unsigned next() {
    if (rest_.empty()) return 0;
    const auto byte = static_cast<unsigned char>(rest_.front());
    rest_.remove_prefix(1);
    return byte;
  }
  std::size_t below(std::size_t n) { return n == 0 ? 0 : (next() | next() << 8) % n; }
  // Multiples of 1/4, so that points often meet, and numbers at which arithmetic goes wrong.
  double number() {
    constexpr double special[] = {0.1, 1.0 / 3, 1e-12, 1e-30, 1e-49, 5e-324, -0.0, 1e7, 1e30, 1e50, 1e51, 1e300};
    const unsigned byte = next();
    return byte < 244 ? (static_cast<int>(byte) - 122) / 4.0 : special[byte - 244];
  }
  template <int Dim>
  Vec<Dim> point() {
    Vec<Dim> x;
    for (int k = 0; k < Dim; ++k) x[k] = number();
    return x;
  }

 private:
  std::string_view rest_;
};

class MeshEdits {
 public:
  explicit MeshEdits(std::string_view bytes) : bytes_(bytes) {}

  OriginalShape<3> shape() {
    for (int n = 0; n < most_edits && bytes_.any() && x_.size() < most_vertices && polygons_.size() < most_polygons;
         ++n)
      edit();
    return {std::move(x_), std::move(polygons_), {}};
  }

 private:
  Index vertex(const Vec<3>& x) {
    x_.push_back(x);
    return static_cast<Index>(x_.size() - 1);
  }
  Index any_vertex() { return static_cast<Index>(bytes_.below(x_.size())); }
  std::vector<Index>& any_polygon() { return polygons_[bytes_.below(polygons_.size())]; }

  // Bottom and top of n corners each, quadrangles between them.
  void add_prism() {
    const auto n = static_cast<Index>(3 + bytes_.below(8));
    const Vec<3> height = bytes_.point<3>();
    const auto first = static_cast<Index>(x_.size());
    for (Index k = 0; k < n; ++k) vertex(bytes_.point<3>());
    for (Index k = 0; k < n; ++k) vertex(x_[static_cast<std::size_t>(first + k)] + height);
    std::vector<Index> bottom, top;
    for (Index k = 0; k < n; ++k) {
      bottom.push_back(first + n - 1 - k);
      top.push_back(first + n + k);
      const Index next = (k + 1) % n;
      polygons_.push_back({first + k, first + next, first + n + next, first + n + k});
    }
    polygons_.push_back(std::move(bottom));
    polygons_.push_back(std::move(top));
  }

  void add_tetrahedron() {
    const Vec<3> at = bytes_.point<3>();
    const double side = bytes_.number();
    const Index a = vertex(at), b = vertex(at + side * Vec<3>::UnitX()), c = vertex(at + side * Vec<3>::UnitY()),
                d = vertex(at + side * Vec<3>::UnitZ());
    for (const std::vector<Index>& face :
         {std::vector{a, c, b}, std::vector{a, b, d}, std::vector{a, d, c}, std::vector{b, c, d}})
      polygons_.push_back(face);
  }

  // A new vertex on an edge, in every polygon that has it: fans of those have flat triangles.
  void split_edge() {
    const std::vector<Index>& polygon = any_polygon();
    if (polygon.size() < 2) return;
    const std::size_t k = bytes_.below(polygon.size());
    const Index a = polygon[k], b = polygon[(k + 1) % polygon.size()];
    const Index middle = vertex(0.5 * (x_[static_cast<std::size_t>(a)] + x_[static_cast<std::size_t>(b)]));
    for (std::vector<Index>& other : polygons_)
      for (std::size_t i = 0; i < other.size(); ++i) {
        const Index c = other[i], d = other[(i + 1) % other.size()];
        if ((c == a && d == b) || (c == b && d == a)) {
          other.insert(other.begin() + static_cast<std::ptrdiff_t>(i) + 1, middle);
          ++i;
        }
      }
  }

  void edit() {
    const unsigned what = bytes_.next() % 12;
    if (what == 0) return add_tetrahedron();
    if (what == 1) return add_prism();
    if (what == 2) return static_cast<void>(vertex(bytes_.point<3>()));
    if (x_.empty() || polygons_.empty()) return add_tetrahedron();
    if (what == 3) {
      std::vector<Index> polygon(bytes_.below(9));
      for (Index& v : polygon) v = any_vertex();
      polygons_.push_back(std::move(polygon));
    }
    if (what == 4) std::ranges::reverse(any_polygon());
    if (what == 5) polygons_.push_back(std::vector<Index>(any_polygon()));
    if (what == 6) polygons_.erase(polygons_.begin() + static_cast<std::ptrdiff_t>(bytes_.below(polygons_.size())));
    if (what == 7) x_[static_cast<std::size_t>(any_vertex())] = bytes_.point<3>();
    if (what == 8) {
      const Vec<3> x = x_[static_cast<std::size_t>(any_vertex())];
      x_[static_cast<std::size_t>(any_vertex())] = x;
    }
    if (what == 9) split_edge();
    if (what == 10)
      for (Index& v : any_polygon()) v = vertex(Vec<3>(x_[static_cast<std::size_t>(v)]));
    if (what == 11)
      for (Index& v : any_polygon())
        if (const Index other = any_vertex(); bytes_.next() % 2 == 1) v = other;
  }

  Bytes bytes_;
  std::vector<Vec<3>> x_;
  std::vector<std::vector<Index>> polygons_;
};

}  // namespace

OriginalShape<3> edited_mesh(std::string_view bytes) { return MeshEdits(bytes).shape(); }

OriginalShape<2> edited_outline(std::string_view text) {
  Bytes bytes(text);
  OriginalShape<2> shape;
  const auto add = [&](const Vec<2>& x) {
    if (shape.polygons.empty()) shape.polygons.emplace_back();
    shape.polygons.back().push_back(static_cast<Index>(shape.vertices.size()));
    shape.vertices.push_back(x);
  };
  const auto last = [&] { return shape.vertices.empty() ? Vec<2>(0, 0) : shape.vertices.back(); };
  for (int n = 0; n < 3 * most_edits && bytes.any() && shape.vertices.size() < most_vertices; ++n) {
    const unsigned what = bytes.next() % 8;
    if (what <= 2) {
      add(bytes.point<2>());
    } else if (what == 3) {
      shape.polygons.emplace_back();
    } else if (what == 4) {
      const Vec<2> at = bytes.point<2>(), side = bytes.point<2>();
      shape.polygons.emplace_back();
      for (const auto& [i, j] : {std::pair{0, 0}, std::pair{1, 0}, std::pair{1, 1}, std::pair{0, 1}})
        add(at + Vec<2>(i * side.x(), j * side.y()));
    } else if (what == 5) {
      const auto corners = static_cast<int>(3 + bytes.below(12)), step = static_cast<int>(1 + bytes.below(4));
      const Vec<2> at = bytes.point<2>();
      const double radius = bytes.number();
      shape.polygons.emplace_back();
      for (int k = 0; k < corners; ++k)
        add(at + radius * Vec<2>(std::cos(2 * M_PI * k * step / corners), std::sin(2 * M_PI * k * step / corners)));
    } else if (what == 6 && !shape.vertices.empty()) {
      const Vec<2> x = shape.vertices[bytes.below(shape.vertices.size())];
      add(x);
    } else {
      const Vec<2> x = last() + 0.25 * bytes.point<2>();
      add(x);
    }
  }
  return shape;
}

}  // namespace shellmatch::fuzz
