#include "energies/cost/element_fields.h"

#include "grid/fields/bump.h"

#include <algorithm>
#include <cmath>

namespace shellmatch {

template <int Dim>
UserFields<Dim>::UserFields(std::vector<std::shared_ptr<const UserField>> fields) : fields_(std::move(fields)) {
  for (const auto& field : fields_) n_components_ += field->n_components;
}

template <int Dim>
std::vector<int> UserFields<Dim>::sizes() const {
  std::vector<int> sizes;
  for (const auto& field : fields_) sizes.push_back(field->n_components);
  return sizes;
}

template <int Dim>
bool UserFields<Dim>::fit(std::span<const Element<Dim>> elements, const ShapeTable<Dim>& shape) const {
  Index last = -1;
  for (const Element<Dim>& element : elements) last = std::max(last, *std::ranges::max_element(element.nodes));
  return std::ranges::all_of(fields_, [&](const auto& field) {
    const std::size_t n = field->values.size() / static_cast<std::size_t>(field->n_components);
    switch (field->place) {
      case UserField::Place::nodes: return n > static_cast<std::size_t>(last) || elements.empty();
      case UserField::Place::cells: return n == elements.size();
      case UserField::Place::points: break;
    }
    return n == elements.size() * shape.points.size();
  });
}

template <int Dim>
void UserFields<Dim>::read(const Element<Dim>& element, std::size_t e, const ShapeTable<Dim>& shape, std::size_t q,
                           double* out) const {
  for (const auto& field : fields_) {
    const auto n = static_cast<std::size_t>(field->n_components);
    const auto at = [&](std::size_t place) { return field->values.data() + place * n; };
    if (field->place == UserField::Place::nodes) {
      std::fill_n(out, n, 0.0);
      for (int c = 0; c < n_corners<Dim>; ++c) {
        const double* corner = at(static_cast<std::size_t>(element.nodes[c]));
        for (std::size_t i = 0; i < n; ++i) out[i] += shape.points[q].n[c] * corner[i];
      }
    } else {
      std::copy_n(at(field->place == UserField::Place::cells ? e : e * shape.points.size() + q), n, out);
    }
    out += n;
  }
}

template class UserFields<2>;
template class UserFields<3>;

namespace {

/// From numbers as the band keeps them.
template <int Dim>
ReferencePoint<Dim, double> unpacked(const std::array<float, Band<Dim>::n_reference>& kept) {
  ReferencePoint<Dim, double> x;
  const auto at = [&](int i) { return static_cast<double>(kept[static_cast<std::size_t>(i)]); };
  x.d1 = at(0);
  for (int i = 0; i < Dim; ++i) x.n1.v[i] = at(1 + i);
  for (int i = 0; i < n_symmetric<Dim>; ++i) x.r1.v[i] = at(1 + Dim + i);
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
    std::array<float, Band<Dim>::n_reference> kept;
    for (std::size_t i = 0; i < kept.size(); ++i) kept[i] = static_cast<float>(flat[i]);
    band.push_back({bump(flat[0], sigma) * volume() * q.weight, unpacked<Dim>(kept)});
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
    std::array<float, Band<Dim>::n_reference> kept;
    for (std::size_t i = 0; i < kept.size(); ++i) kept[i] = point.kept[i][lane % Band<Dim>::n_lanes];
    band[q] = {point.weight[lane % Band<Dim>::n_lanes], unpacked<Dim>(kept)};
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
