#pragma once
/// \file
/// Fields of a user's own, such as a rotation that lags behind phi or a weight, which a term reads beside those of the
/// shapes (OwnField, energies/terms/depends_on.h).

#include "energies/autodiff/pack.h"
#include "energies/elements/shape_table.h"

#include <array>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace shellmatch {

/// Values of one field. They may be changed between evaluations.
struct UserField {
  enum class Place {
    nodes,  ///< of the grid, hanging nodes included; multilinear on each cell
    cells,  ///< one value for each element, in the order of Unknowns::elements()
    points  ///< one for each quadrature point, element after element, in the order of ShapeTable::points
  };
  Place place = Place::nodes;
  int n_components = 1;
  std::vector<double> values;  ///< the components of one place after another
};

/// The fields that one term reads, in the order of its Reads.
template <int Dim>
class UserFields {
 public:
  using Pack = autodiff::Pack;

  UserFields() = default;
  explicit UserFields(std::vector<std::shared_ptr<const UserField>> fields);

  bool empty() const { return fields_.empty(); }
  /// Of all fields together.
  int n_components() const { return n_components_; }
  /// Those of each field.
  std::vector<int> sizes() const;
  /// Is there a value for each of these elements and points?
  bool fit(std::span<const Element<Dim>> elements, const ShapeTable<Dim>& shape) const;

  /// The components at quadrature point q of element number e.
  void read(const Element<Dim>& element, std::size_t e, const ShapeTable<Dim>& shape, std::size_t q, double* out) const;
  /// The same at eight elements, those with the numbers number(lane).
  template <class NumberOf>
  void read(std::span<const Element<Dim>> elements, NumberOf&& number, const ShapeTable<Dim>& shape, std::size_t q,
            Pack* out) const {
    static thread_local std::vector<double> one;
    one.resize(static_cast<std::size_t>(n_components_));
    for (int lane = 0; lane < autodiff::pack_size; ++lane) {
      const auto e = static_cast<std::size_t>(number(lane));
      read(elements[e], e, shape, q, one.data());
      for (int i = 0; i < n_components_; ++i) out[i][lane] = one[static_cast<std::size_t>(i)];
    }
  }

 private:
  std::vector<std::shared_ptr<const UserField>> fields_;
  int n_components_ = 0;
};

extern template class UserFields<2>;
extern template class UserFields<3>;

}  // namespace shellmatch
