#include "energies/cost/element_fields.h"

#include "grid/fields/bump.h"

#include <algorithm>
#include <cmath>

namespace shellmatch {

namespace {

template <int Dim>
ReferencePoint<Dim, double> unpacked(const std::array<double, Band<Dim>::n_reference>& flat) {
  ReferencePoint<Dim, double> x;
  x.d1 = flat[0];
  std::copy_n(flat.begin() + 1, Dim, x.n1.v.begin());
  std::copy_n(flat.begin() + 1 + Dim, n_symmetric<Dim>, x.r1.v.begin());
  return x;
}

}  // namespace

template <int Dim>
ElementFields<Dim>::ElementFields(const Element<Dim>& element, const GeometryPair<Dim>& shapes, double sigma,
                                  const ShapeTable<Dim>& s)
    : side(element.side), shape(&s), target(&shapes.target) {
  bool meets_band = false;
  for (const auto& q : s.points) {
    const auto values = shapes.reference.value(element.corner + element.side * q.xi);
    const auto flat = Band<Dim>::reference_point(values, shapes.root_is_inverse);
    meets_band = meets_band || std::abs(flat[0]) < sigma;
    band.push_back({bump(flat[0], sigma) * volume() * q.weight, unpacked<Dim>(flat)});
  }
  if (!meets_band) band.clear();
}

template <int Dim>
void ElementFields<Dim>::assign(const Element<Dim>& element, const Band<Dim>& of, Index lane,
                                const GeometryField<Dim>& t, const ShapeTable<Dim>& s) {
  side = element.side;
  shape = &s;
  target = &t;
  band.resize(lane == no_index ? 0 : s.points.size());
  for (std::size_t q = 0; q < band.size(); ++q) {
    const auto& point = of.point(static_cast<std::size_t>(lane / Band<Dim>::n_lanes), q);
    std::array<double, Band<Dim>::n_reference> flat;
    for (std::size_t i = 0; i < flat.size(); ++i) flat[i] = point.reference[i][lane % Band<Dim>::n_lanes];
    band[q] = {point.weight[lane % Band<Dim>::n_lanes], unpacked<Dim>(flat)};
  }
}

template <int Dim>
void ElementFields<Dim>::read_own(const UserFields<Dim>& fields, const Element<Dim>& element, std::size_t number) {
  const auto n = static_cast<std::size_t>(fields.n_components());
  own.resize(n * shape->points.size());
  for (std::size_t q = 0; n > 0 && q < shape->points.size(); ++q)
    fields.read(element, number, *shape, q, own.data() + q * n);
}

template <int Dim>
double ElementFields<Dim>::volume() const {
  double volume = 1;
  for (int k = 0; k < Dim; ++k) volume *= side;
  return volume;
}

template struct ElementFields<2>;
template struct ElementFields<3>;

}  // namespace shellmatch
