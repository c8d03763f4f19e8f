#pragma once
/// \file
/// Writes a comparison of curvatures as text, JSON, a coloured mesh and pictures.

#include "matching/shape_report/curvature_comparison.h"

#include <string>

namespace shellmatch {

/// Descriptions that a report gives besides the figures.
struct CurvatureSubject {
  std::string source;
  MeshFit fit;
  CoefficientOptions coefficients;
};

/// A table: one row for each level, one block for each kind of comparison, with the observed order of the medians.
template <int Dim>
std::string curvature_text(const CurvatureComparison<Dim>& comparison, const CurvatureSubject& subject);

/// The figures as one JSON object.
template <int Dim>
std::string curvature_json(const CurvatureComparison<Dim>& comparison, const CurvatureSubject& subject);

/// Writes the surface with k1, k2 and the direction of k1 by the grid and by the mesh fit, and the mean curvature as
/// colours and as the attribute `quality`. Binary PLY, which ParaView and MeshLab can show; in the plane CSV.
void write_curvature_mesh(const CurvatureComparison<3>& comparison, const std::string& path);
void write_curvature_mesh(const CurvatureComparison<2>& comparison, const std::string& path);

/// Draws for every vertex a point with the grid's curvature over the expected one (by formula if there is one, else by
/// the mesh fit); at most a few thousand points, without the 2 % that lie farthest out.
template <int Dim>
void write_curvature_scatter(const CurvatureComparison<Dim>& comparison, const std::string& path);

/// Draws the surface coloured by the grid's curvatures, by the expected ones, and by their difference.
template <int Dim>
void write_curvature_picture(const CurvatureComparison<Dim>& comparison, const std::string& title,
                             const std::string& path);

}  // namespace shellmatch
