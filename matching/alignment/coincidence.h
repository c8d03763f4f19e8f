#pragma once
/// \file
/// Shapes that already lie as they belong, at least in what both have: one bone cut at two lengths, a part and its
/// whole.

#include "matching/alignment/alignment.h"
#include "matching/input/shape_pair.h"

#include <array>
#include <memory>

namespace shellmatch {

/// Which part of each shape the other one has in the same place.
template <int Dim>
class Coincidence {
 public:
  explicit Coincidence(const ShapePair<Dim>& shapes);
  ~Coincidence();

  /// Of the shape of which more coincides; of what was observed, by area (length).
  double share() const { return share_; }
  /// Whether nearly all of one shape lies on the other: by chance or in another pose it does not.
  bool decides() const { return share_ >= 0.8; }

  /// Leaves out pairs of which either end coincides: such points belong where they are. Leaves out all if the map takes
  /// most of these elsewhere, as the image of a symmetry does. \param pairs in the user's coordinates
  void keep_others(std::vector<Landmark<Dim>>& pairs) const;

 private:
  struct Side;
  std::unique_ptr<Side> sides_[2];  ///< of the reference and of the template
  double share_ = 0;
};

/// Root mean square distance between the shapes with the reference moved by `pose`, from the reference, from the
/// template, or the root of both squares' sum: what a pose that was found from one component of several has to make
/// smaller. Distances beyond a tenth of the template's diagonal count as that.
template <int Dim>
double distance_after(const ShapePair<Dim>& shapes, const Similarity<Dim>& pose,
                      const std::array<bool, 2>& from = {true, true});

}  // namespace shellmatch
