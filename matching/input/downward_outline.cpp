#include "matching/input/downward_outline.h"

#include "geometry/repair/make_shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace shellmatch {

namespace {

// Where the line at a height enters and leaves the shape, in order.
std::vector<double> crossings(const Surface<2>& s, double y) {
  std::vector<double> result;
  for (const auto& [a, b] : s.facets) {
    const Vec<2>&p = s.vertices[a], &q = s.vertices[b];
    if ((p.y() > y) != (q.y() > y)) result.push_back(p.x() + (q.x() - p.x()) * (y - p.y()) / (q.y() - p.y()));
  }
  std::ranges::sort(result);
  return result;
}

double length(const std::vector<double>& ends) {
  double sum = 0;
  for (std::size_t k = 0; k + 1 < ends.size(); k += 2) sum += ends[k + 1] - ends[k];
  return sum;
}

double common_length(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0, j = 0; i + 1 < a.size() && j + 1 < b.size();) {
    sum += std::max(0.0, std::min(a[i + 1], b[j + 1]) - std::max(a[i], b[j]));
    (a[i + 1] < b[j + 1] ? i : j) += 2;
  }
  return sum;
}

// y -> factor y + height: the frame of pictures.
void turn(std::vector<Vec<2>>& points, double factor, double height) {
  for (Vec<2>& x : points) x.y() = factor * x.y() + height;
}

}  // namespace

double common_share(const Surface<2>& a, const Surface<2>& b) {
  constexpr int n_lines = 1000;
  Box<2> box = bounding_box(a.vertices);
  for (const Vec<2>& x : b.vertices) box.add(x);
  double common = 0, either = 0;
  for (int k = 0; k < n_lines; ++k) {
    const double y = box.min.y() + (k + 0.5) / n_lines * (box.max.y() - box.min.y());
    const std::vector<double> in_a = crossings(a, y), in_b = crossings(b, y);
    const double both = common_length(in_a, in_b);
    common += both;
    either += length(in_a) + length(in_b) - both;
  }
  return either > 0 ? common / either : 0;
}

std::string turn_downward_outline(Shape<2>& outline, const Shape<2>& picture, double height) {
  const double upward = common_share(outline.surface, picture.surface);
  // Drawings in pixels are turned already, but about the top of the picture.
  const bool is_turned = outline.original.frame.y_scale < 0;
  const double factor = is_turned ? 1 : -1;
  Surface<2> turned = outline.surface;
  turn(turned.vertices, factor, height);
  const double downward = common_share(turned, picture.surface);
  if (downward < 0.6 || downward < upward + 0.1 || 1 - downward > (1 - upward) / 3) return "";
  turn(outline.original.vertices, factor, height);
  outline.original.frame = outline.original.frame.then(factor, height);
  std::string unit = std::move(outline.unit);
  outline = make_shape(std::move(outline.original), outline.source, std::move(outline.notes));
  outline.unit = std::move(unit);
  return fmt::format(
      "{}: fits {} as it lies with y downward ({:.0f} % in common, {:.0f} % {}): used as y = {:g} - y, the frame of "
      "pictures, with its "
      "landmarks; give points that `apply` is to move in that frame (docs/pictures.md)",
      outline.source, picture.source, 100 * downward, 100 * upward, is_turned ? "otherwise" : "with y upward", height);
}

}  // namespace shellmatch
