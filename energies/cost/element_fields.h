#pragma once
/// \file
/// What the terms read on one element.

#include "energies/autodiff/pack.h"
#include "energies/elements/band.h"
#include "energies/elements/shape_table.h"
#include "energies/elements/unknowns.h"
#include "energies/fields/geometry_field.h"

#include <array>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace shellmatch {

/// Values of a field of the user's own, such as a rotation that lags behind phi or a weight, which a term reads beside
/// those of the shapes (OwnField, energies/terms/depends_on.h). They may be changed between evaluations.
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

/// An element, its quadrature points and the coefficients there.
template <int Dim>
struct ElementFields {
  /// The reference at a quadrature point within the band.
  struct BandPoint {
    double weight = 0;  ///< eta_sigma(d1) h^Dim w_q; 0 outside the band
    ReferencePoint<Dim, double> reference{};
  };

  double side = 0;
  const ShapeTable<Dim>* shape = nullptr;
  const GeometryField<Dim>* target = nullptr;
  std::vector<BandPoint> band;  ///< by quadrature point of `shape`; empty where the band misses the element
  std::vector<double> own;      ///< components of the term's own fields, by quadrature point

  ElementFields() = default;
  /// Reads the reference at the quadrature points. shapes and shape must outlive this object.
  /// \param sigma  half width of the band
  ElementFields(const Element<Dim>& element, const GeometryPair<Dim>& shapes, double sigma,
                const ShapeTable<Dim>& shape);

  /// That of an element of a grid whose band has been computed.
  /// \param lane  number of the element's batch in the band times lanes plus its lane; no_index outside the band
  void assign(const Element<Dim>& element, const Band<Dim>& band, Index lane, const GeometryField<Dim>& target,
              const ShapeTable<Dim>& shape);

  /// Reads the own fields of one term on this element, which has this number.
  void read_own(const UserFields<Dim>& fields, const Element<Dim>& element, std::size_t number);

  double volume() const;  ///< side^Dim
};

extern template struct ElementFields<2>;
extern template struct ElementFields<3>;

}  // namespace shellmatch
