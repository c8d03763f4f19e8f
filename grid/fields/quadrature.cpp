#include "grid/fields/quadrature.h"

#include "base/error.h"

#include <array>

namespace shellmatch {

namespace {

struct Point {
  double x, weight;
};

// Roots of the Legendre polynomials and their weights, moved from [-1, 1] to [0, 1].
constexpr std::array<std::array<Point, max_gauss_points>, max_gauss_points> gauss_legendre = {{
    {{{0.5, 1.0}}},
    {{{0.21132486540518711775, 0.5}, {0.78867513459481288225, 0.5}}},
    {{{0.11270166537925831148, 5.0 / 18}, {0.5, 8.0 / 18}, {0.88729833462074168852, 5.0 / 18}}},
    {{{0.069431844202973712388, 0.17392742256872692869},
      {0.3300094782075718676, 0.32607257743127307131},
      {0.6699905217924281324, 0.32607257743127307131},
      {0.93056815579702628761, 0.17392742256872692869}}},
    {{{0.046910077030668003601, 0.11846344252809454376},
      {0.23076534494715845448, 0.23931433524968323402},
      {0.5, 64.0 / 225},
      {0.76923465505284154552, 0.23931433524968323402},
      {0.9530899229693319964, 0.11846344252809454376}}},
}};

}  // namespace

template <int Dim>
std::vector<QuadraturePoint<Dim>> gauss_rule(int n) {
  SHELLMATCH_CHECK(n >= 1 && n <= max_gauss_points, "there are Gauss rules of 1 to 5 points");
  const auto& line = gauss_legendre[n - 1];
  int count = 1;
  for (int k = 0; k < Dim; ++k) count *= n;
  std::vector<QuadraturePoint<Dim>> rule(count);
  for (int q = 0; q < count; ++q) {
    rule[q].weight = 1;
    for (int k = 0, rest = q; k < Dim; ++k, rest /= n) {
      rule[q].point[k] = line[rest % n].x;
      rule[q].weight *= line[rest % n].weight;
    }
  }
  return rule;
}

SHELLMATCH_2D_3D(gauss_rule);

}  // namespace shellmatch
