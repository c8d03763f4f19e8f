#pragma once
/// \file
/// What the terms read on one element.

#include "energies/elements/band.h"
#include "energies/elements/unknowns.h"
#include "energies/elements/user_field.h"
#include "energies/fields/geometry_field.h"

#include <span>
#include <vector>

namespace shellmatch {

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
