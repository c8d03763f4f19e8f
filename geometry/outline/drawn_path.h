#pragma once
/// \file
/// Lines and curves that bound areas in drawings, and the polygons that stand for them.

#include "base/types.h"

#include <vector>

namespace shellmatch {

/// x -> linear x + offset.
struct PlaneMap {
  Mat<2> linear = Mat<2>::Identity();
  Vec<2> offset = Vec<2>::Zero();
  Vec<2> operator()(const Vec<2>& x) const { return linear * x + offset; }
  /// First `other`, then this one.
  PlaneMap operator*(const PlaneMap& other) const { return {linear * other.linear, (*this)(other.offset)}; }
};

/// A line to `end`, or a cubic Bezier curve with two control points in between.
struct PathPiece {
  Vec<2> end;
  Vec<2> control[2];
  bool is_curve;
};

/// Pieces end to end.
struct DrawnPath {
  Vec<2> start;
  std::vector<PathPiece> pieces;
  bool is_closed = false;  ///< by the file's word; an open one is closed by a line

  const Vec<2>& end() const { return pieces.empty() ? start : pieces.back().end; }
  void move(const PlaneMap& map);
};

/// Builds paths as drawing programs do: by a pen that goes on from where it is.
class PathPen {
 public:
  void move_to(const Vec<2>& x);
  void line_to(const Vec<2>& x);
  void quadratic_to(const Vec<2>& control, const Vec<2>& x);
  void cubic_to(const Vec<2>& first, const Vec<2>& second, const Vec<2>& x);
  /// The elliptical arc of SVG 2 (9.5.1): radii, the turn of its axes in degrees, which of the four arcs.
  void arc_to(Vec<2> radii, double degrees, bool is_large, bool is_positive, const Vec<2>& x);
  /// Back to where the path began, from where the next one goes on.
  void close();

  bool is_empty() const { return paths_.empty(); }
  const Vec<2>& position() const { return at_; }
  /// The paths that have a piece.
  std::vector<DrawnPath> take();

 private:
  DrawnPath& open_path();

  std::vector<DrawnPath> paths_;
  Vec<2> at_ = Vec<2>::Zero();
  bool is_new_ = true;  // the next piece begins a path
};

/// A polygon through the points.
DrawnPath path_through(const std::vector<Vec<2>>& points, bool is_closed);
/// The ellipse centre + cos(t) a + sin(t) b.
DrawnPath ellipse_path(const Vec<2>& centre, const Vec<2>& a, const Vec<2>& b);
/// A rectangle, its corners rounded by quarters of ellipses. \pre radii of at most half its sides
DrawnPath rectangle_path(const Vec<2>& corner, const Vec<2>& size, const Vec<2>& radii);

/// Points of which the polygon is nowhere farther from the path than `tolerance`, by Wang's bound on the number of
/// steps along a cubic (Wang, 'The subdivision method for finding the intersection between two Bezier curves or
/// surfaces', 1984). A last point that repeats the first is left out. \pre tolerance > 0
std::vector<Vec<2>> flattened(const DrawnPath& path, double tolerance);

}  // namespace shellmatch
