#pragma once
/// \file
/// What a comparison of curvatures is written as: text, JSON, a coloured mesh and pictures.

#include "matching/shape_report/curvature_comparison.h"

#include <string>

namespace shellmatch {

/// What a report says besides the numbers.
struct CurvatureSubject {
  std::string source;
  MeshFit fit;
  CoefficientOptions coefficients;
};

/// A table for people: one row per level, one block per kind of comparison, with the observed order of the medians.
template <int Dim>
std::string curvature_text(const CurvatureComparison<Dim>& comparison, const CurvatureSubject& subject);

/// For machines: one JSON object.
template <int Dim>
std::string curvature_json(const CurvatureComparison<Dim>& comparison, const CurvatureSubject& subject);

/// The surface with k1, k2 and the direction of k1 from the grid, those of the mesh fit, colours by the mean curvature
/// and the same as `quality`: binary PLY, which ParaView and MeshLab show; in the plane CSV.
void write_curvature_mesh(const CurvatureComparison<3>& comparison, const std::string& path);
void write_curvature_mesh(const CurvatureComparison<2>& comparison, const std::string& path);

/// Every vertex as a point, the grid's curvatures over those expected (by formula where there is one, else by the mesh
/// fit); at most a few thousand of them, and the farthest 2 % left out.
template <int Dim>
void write_curvature_scatter(const CurvatureComparison<Dim>& comparison, const std::string& path);

/// The surface coloured by the grid's curvatures, by the expected ones, and by their difference.
template <int Dim>
void write_curvature_picture(const CurvatureComparison<Dim>& comparison, const std::string& title,
                             const std::string& path);

}  // namespace shellmatch
