#pragma once
/// \file
/// A weight in [0, 1] on the terms of the band: 0 where one of the shapes has no data.

#include "base/types.h"

#include <cstddef>
#include <span>
#include <vector>

namespace shellmatch {

/// A product of a weight in the reference's domain, which stays, and one in the template's, which is asked for again as
/// the points move. It is asked for at several points at once, which lie close to each other if they are of one
/// element.
template <int Dim>
class BandMask {
 public:
  virtual ~BandMask() = default;
  /// \param weights one for each point
  virtual void reference_weights(std::span<const Vec<Dim>> x, std::span<double> weights) const = 0;
  virtual void template_weights(std::span<const Vec<Dim>> y, std::span<double> weights) const = 0;

  /// For points x of the reference's domain and their images y in the template's.
  std::vector<double> weights(std::span<const Vec<Dim>> x, std::span<const Vec<Dim>> y) const {
    std::vector<double> product(x.size()), of_template(x.size());
    reference_weights(x, product);
    template_weights(y, of_template);
    for (std::size_t i = 0; i < product.size(); ++i) product[i] *= of_template[i];
    return product;
  }
};

}  // namespace shellmatch
