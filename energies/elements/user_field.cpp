#include "energies/elements/user_field.h"

#include <algorithm>

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

}  // namespace shellmatch
