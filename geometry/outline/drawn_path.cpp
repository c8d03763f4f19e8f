#include "geometry/outline/drawn_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace shellmatch {

namespace {

constexpr double pi = std::numbers::pi;

// Cubics for the arc from t0 to t0 + turn of an ellipse, each a twelfth of it at most: they are 1e-6 radii off.
template <class Add>
void for_each_cubic(const Vec<2>& centre, const Vec<2>& a, const Vec<2>& b, double t0, double turn, const Add& add) {
  const int n = std::max(1, static_cast<int>(std::ceil(std::abs(turn) / (pi / 6) - 1e-9)));
  const double step = turn / n, reach = 4.0 / 3 * std::tan(step / 4);
  for (int k = 0; k < n; ++k) {
    const double t = t0 + k * step, u = t0 + (k + 1) * step;
    const Vec<2> from = centre + std::cos(t) * a + std::sin(t) * b, to = centre + std::cos(u) * a + std::sin(u) * b;
    add(from + reach * (std::cos(t) * b - std::sin(t) * a), to - reach * (std::cos(u) * b - std::sin(u) * a), to);
  }
}

}  // namespace

void DrawnPath::move(const PlaneMap& map) {
  start = map(start);
  for (PathPiece& piece : pieces) {
    piece.end = map(piece.end);
    for (Vec<2>& c : piece.control) c = map(c);
  }
}

DrawnPath& PathPen::open_path() {
  if (is_new_) paths_.push_back({at_, {}, false});
  is_new_ = false;
  return paths_.back();
}

void PathPen::move_to(const Vec<2>& x) {
  at_ = x;
  is_new_ = true;
}

void PathPen::line_to(const Vec<2>& x) {
  open_path().pieces.push_back({x, {at_, x}, false});
  at_ = x;
}

void PathPen::cubic_to(const Vec<2>& first, const Vec<2>& second, const Vec<2>& x) {
  open_path().pieces.push_back({x, {first, second}, true});
  at_ = x;
}

void PathPen::quadratic_to(const Vec<2>& control, const Vec<2>& x) {
  cubic_to(at_ + 2.0 / 3 * (control - at_), x + 2.0 / 3 * (control - x), x);
}

// From end points to the centre: SVG 1.1, appendix F.6.5 and F.6.6.
void PathPen::arc_to(Vec<2> radii, double degrees, bool is_large, bool is_positive, const Vec<2>& x) {
  radii = radii.cwiseAbs();
  if (x == at_) return;
  if (radii.minCoeff() == 0) return line_to(x);
  const double turn = degrees * pi / 180;
  Mat<2> axes;
  axes << std::cos(turn), -std::sin(turn), std::sin(turn), std::cos(turn);
  const Vec<2> half = axes.transpose() * (at_ - x) / 2;
  const double too_long = half.cwiseQuotient(radii).squaredNorm();
  if (too_long > 1) radii *= std::sqrt(too_long);
  const Vec<2> p = half.cwiseQuotient(radii);
  const double length = p.norm(), beside = std::sqrt(std::max(0.0, 1 - length * length));
  Vec<2> c = beside / length * Vec<2>(p.y(), -p.x());
  if (is_large == is_positive) c = -c;
  const Vec<2> begin = p - c, end = -p - c;
  const double t0 = std::atan2(begin.y(), begin.x());
  double angle = std::atan2(end.y(), end.x()) - t0;
  if (is_positive && angle < 0) angle += 2 * pi;
  if (!is_positive && angle > 0) angle -= 2 * pi;
  const Vec<2> centre = axes * c.cwiseProduct(radii) + (at_ + x) / 2;
  if (!std::isfinite(angle) || !centre.allFinite()) return line_to(x);
  std::vector<PathPiece>& pieces = open_path().pieces;
  for_each_cubic(centre, axes.col(0) * radii.x(), axes.col(1) * radii.y(), t0, angle,
                 [&](const Vec<2>& first, const Vec<2>& second, const Vec<2>& to) {
                   pieces.push_back({to, {first, second}, true});
                 });
  pieces.back().end = at_ = x;
}

void PathPen::close() {
  if (is_new_ || paths_.empty()) return;
  paths_.back().is_closed = true;
  move_to(paths_.back().start);
}

std::vector<DrawnPath> PathPen::take() {
  is_new_ = true;
  return std::exchange(paths_, {});
}

DrawnPath path_through(const std::vector<Vec<2>>& points, bool is_closed) {
  DrawnPath path{points.empty() ? Vec<2>(Vec<2>::Zero()) : points.front(), {}, is_closed};
  path.pieces.reserve(points.size());
  for (std::size_t i = 1; i < points.size(); ++i) path.pieces.push_back({points[i], {points[i - 1], points[i]}, false});
  return path;
}

DrawnPath ellipse_path(const Vec<2>& centre, const Vec<2>& a, const Vec<2>& b) {
  DrawnPath path{centre + a, {}, true};
  for_each_cubic(centre, a, b, 0, 2 * pi, [&](const Vec<2>& first, const Vec<2>& second, const Vec<2>& to) {
    path.pieces.push_back({to, {first, second}, true});
  });
  path.pieces.back().end = path.start;
  return path;
}

DrawnPath rectangle_path(const Vec<2>& corner, const Vec<2>& size, const Vec<2>& radii) {
  PathPen pen;
  const Vec<2> end = corner + size;
  const auto arc = [&](double x, double y) { pen.arc_to(radii, 0, false, true, {x, y}); };
  pen.move_to({corner.x() + radii.x(), corner.y()});
  pen.line_to({end.x() - radii.x(), corner.y()});
  arc(end.x(), corner.y() + radii.y());
  pen.line_to({end.x(), end.y() - radii.y()});
  arc(end.x() - radii.x(), end.y());
  pen.line_to({corner.x() + radii.x(), end.y()});
  arc(corner.x(), end.y() - radii.y());
  pen.line_to({corner.x(), corner.y() + radii.y()});
  arc(corner.x() + radii.x(), corner.y());
  pen.close();
  return std::move(pen.take().front());
}

std::vector<Vec<2>> flattened(const DrawnPath& path, double tolerance) {
  std::vector<Vec<2>> points{path.start};
  for (const PathPiece& piece : path.pieces) {
    if (piece.is_curve) {
      const Vec<2> a = points.back(), &b = piece.control[0], &c = piece.control[1], &d = piece.end;
      const double bend = std::max((a - 2 * b + c).norm(), (b - 2 * c + d).norm());
      const double n = std::ceil(std::sqrt(0.75 * bend / tolerance));
      for (int k = 1; k < n; ++k) {
        const double t = k / n, s = 1 - t;
        points.push_back(s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * d);
      }
    }
    points.push_back(piece.end);
  }
  if (points.size() > 1 && points.back() == points.front()) points.pop_back();
  return points;
}

}  // namespace shellmatch
