#include "energies/elements/shape_table.h"

namespace shellmatch {

template <int Dim>
ShapeTable<Dim>::ShapeTable(int n) : points_per_direction(n) {
  for (const auto& q : gauss_rule<Dim>(n)) {
    Point p{.weight = q.weight, .xi = q.point, .n = {}, .dn = {}};
    for (int c = 0; c < n_corners<Dim>; ++c) {
      std::array<double, Dim> factor, slope;
      for (int k = 0; k < Dim; ++k) {
        const bool upper = (c >> k) & 1;
        factor[k] = upper ? p.xi[k] : 1 - p.xi[k];
        slope[k] = upper ? 1.0 : -1.0;
      }
      p.n[c] = 1;
      for (int k = 0; k < Dim; ++k) {
        p.n[c] *= factor[k];
        p.dn[c][k] = 1;
        for (int j = 0; j < Dim; ++j) p.dn[c][k] *= j == k ? slope[j] : factor[j];
      }
    }
    points.push_back(p);
  }
}

template struct ShapeTable<2>;
template struct ShapeTable<3>;

}  // namespace shellmatch
