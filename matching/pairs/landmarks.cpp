#include "matching/pairs/landmarks.h"

#include "base/error.h"

#include <cmath>

namespace shellmatch {

namespace {

/// One of the two shapes.
template <int Dim>
struct Side {
  const char* name;
  const SignedDistance<Dim>& shape;
  double diagonal;  ///< of the template
};

/// The point in the unit domain. \param origin where it was read
template <int Dim>
Vec<Dim> placed(const Landmark<Dim>& landmark, const Vec<Dim>& x, const std::string& origin, const Side<Dim>& side,
                const Similarity<Dim>& placement, double max_distance) {
  const std::string what = fmt::format("{}{}landmark '{}': its point of the {}", origin, origin.empty() ? "" : ": ",
                                       landmark.name, side.name);
  if (!x.allFinite()) throw_input_error("{} is not finite", what);
  const Vec<Dim> y = placement(x);
  if ((y.array() < 0).any() || (y.array() > 1).any())
    throw_input_error("{} lies outside of the domain; are its units and its frame those of the {}?", what, side.name);
  const double distance = std::abs(side.shape(y)) / side.diagonal;
  if (distance > max_distance)
    throw_input_error("{} lies {:.3g} diagonals from that shape; at most {:.3g} are allowed (landmarks.max_distance); are its "
                      "units and its frame those of the {}?",
                      what, distance, max_distance, side.name);
  return y;
}

}  // namespace

template <int Dim>
PairSet<Dim> landmark_pairs(const std::string& name, const std::vector<Landmark<Dim>>& landmarks,
                            const LandmarkOptions& options, const Similarity<Dim>& pose, const Similarity<Dim>& placement, const SignedDistance<Dim>& reference,
                            const SignedDistance<Dim>& template_shape) {
  const double diagonal = bounding_box(template_shape.surface().vertices).diagonal();
  const double area = surface_measure(reference.surface());
  PairSet<Dim> set;
  set.name = name;
  set.factor = options.weight;
  set.pairs.loss = options.loss;
  set.pairs.scale = options.scale * diagonal;
  for (const Landmark<Dim>& landmark : landmarks) {
    if (!(landmark.weight > 0 && std::isfinite(landmark.weight)))
      throw_input_error("landmark '{}': its weight {} is no positive number", landmark.name, landmark.weight);
    PointPair<Dim> pair;
    pair.p = placed(landmark, pose(landmark.on_reference), landmark.reference_origin, {"reference", reference, diagonal}, placement,
                    options.max_distance);
    pair.y = placed(landmark, landmark.on_template, landmark.template_origin, {"template", template_shape, diagonal}, placement,
                    options.max_distance);
    pair.weight = landmark.weight * area / static_cast<double>(landmarks.size());
    set.pairs.pairs.push_back(pair);
  }
  return set;
}

#define SHELLMATCH_INSTANTIATE(Dim)                                                                                       \
  template PairSet<Dim> landmark_pairs<Dim>(const std::string&, const std::vector<Landmark<Dim>>&,                        \
                                            const LandmarkOptions&, const Similarity<Dim>&, const Similarity<Dim>&,       \
                                            const SignedDistance<Dim>&, const SignedDistance<Dim>&)
SHELLMATCH_INSTANTIATE(2);
SHELLMATCH_INSTANTIATE(3);
#undef SHELLMATCH_INSTANTIATE

}  // namespace shellmatch
