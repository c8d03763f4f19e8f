#pragma once
/// \file
/// Options of the geometric coefficients on the grid.

#include "base/options.h"

namespace shellmatch {

enum class Classification { absolute, shift };
template <>
struct EnumNames<Classification> {
  static constexpr std::pair<Classification, std::string_view> names[] = {{Classification::absolute, "absolute"},
                                                                          {Classification::shift, "shift"}};
};

enum class MassKind { consistent, lumped };
template <>
struct EnumNames<MassKind> {
  static constexpr std::pair<MassKind, std::string_view> names[] = {{MassKind::consistent, "consistent"},
                                                                    {MassKind::lumped, "lumped"}};
};

enum class DistanceMethod { exact, fast_marching };
template <>
struct EnumNames<DistanceMethod> {
  static constexpr std::pair<DistanceMethod, std::string_view> names[] = {
      {DistanceMethod::exact, "exact"}, {DistanceMethod::fast_marching, "fast_marching"}};
};

enum class RootMethod { eigen, franca };
template <>
struct EnumNames<RootMethod> {
  static constexpr std::pair<RootMethod, std::string_view> names[] = {{RootMethod::eigen, "eigen"},
                                                                      {RootMethod::franca, "franca"}};
};

enum class FieldInterpolation { smooth, multilinear };
template <>
struct EnumNames<FieldInterpolation> {
  static constexpr std::pair<FieldInterpolation, std::string_view> names[] = {
      {FieldInterpolation::smooth, "smooth"}, {FieldInterpolation::multilinear, "multilinear"}};
};

/// Normals, shape operators and their roots from the nodal distances (paper, section 5).
struct CoefficientOptions {
  DistanceMethod distance = DistanceMethod::exact;
  MassKind normal_mass = MassKind::lumped;
  int neighbours = 0;
  double fit_weight = 0;
  Classification classification = Classification::absolute;
  double tau = 1;
  RootMethod root = RootMethod::eigen;
  double max_curvature_times_h = 1;
  bool invert_at_point = true;
  FieldInterpolation interpolation = FieldInterpolation::smooth;
  double reach = 1.5;
  int levels_ahead = 1;
  static void describe(auto& self, auto& visit) {
    visit("distance", self.distance,
          {.meaning = "signed distances at the nodes: exact, from the closest point of the surface, or fast_marching, "
                      "as the paper: exact next to the surface, and of first order from there"});
    visit("tau", self.tau,
          {.unit = "1/length",
           .min = 0,
           .min_excluded = true,
           .meaning = "smallest curvature that the classification lets through"});
    visit("max_curvature_times_h", self.max_curvature_times_h,
          {.min = 0,
           .meaning = "curvatures are capped at this over the finest cell's side, as the grid cannot carry more; 0 "
                      "means no cap"});
    visit("invert_at_point", self.invert_at_point,
          {.meaning = "interpolate C(S1)^(1/2) and invert at the quadrature point, so that identical shapes cost no "
                      "bending; false interpolates C(S1)^(-1/2), as the paper"});
    visit("interpolation", self.interpolation,
          {.meaning =
               "distances, normals and roots between the nodes: smooth, by quadratic splines that are C1 throughout, "
               "each shape on a grid of its own; multilinear, as the paper, both shapes on the grid of phi"});
  }
};

}  // namespace shellmatch
