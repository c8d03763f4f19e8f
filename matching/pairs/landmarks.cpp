#include "matching/pairs/landmarks.h"

#include "base/error.h"
#include "base/stop.h"
#include "geometry/distance/facet_tree.h"
#include "geometry/surface/facet_point.h"

#include <cmath>

namespace shellmatch {

namespace {

/// A landmark's point on one of the two shapes.
template <int Dim>
struct Marked {
  const Landmark<Dim>& landmark;
  bool is_on_reference;

  const Vec<Dim>& point() const { return is_on_reference ? landmark.on_reference : landmark.on_template; }
  std::string_view shape() const { return is_on_reference ? landmark.reference_name : landmark.template_name; }
  std::string name() const {
    const std::string& origin = is_on_reference ? landmark.reference_origin : landmark.template_origin;
    return fmt::format("{}{}landmark '{}': its point of the {}", origin, origin.empty() ? "" : ": ", landmark.name,
                       shape());
  }
};

template <int Dim>
void check(const Marked<Dim>& marked) {
  if (!marked.point().allFinite()) throw_input_error("{} is not finite", marked.name());
  const double weight = marked.landmark.weight;
  if (!(weight > 0 && std::isfinite(weight)))
    throw_input_error("landmark '{}': its weight {} is no positive number", marked.landmark.name, weight);
}

/// \param distance from the shape, in diagonals of the template
template <int Dim>
void check_distance(const Marked<Dim>& marked, double distance, double most) {
  if (distance > most)
    throw_input_error(
        "{} lies {:.3g} diagonals from that shape; at most {:.3g} are allowed (landmarks.max_distance); are its "
        "units and its frame those of the {}?",
        marked.name(), distance, most, marked.shape());
}

/// The point in the unit domain. \param x the point, after the pose
template <int Dim>
Vec<Dim> placed(const Marked<Dim>& marked, const Vec<Dim>& x, const Similarity<Dim>& placement,
                const SignedDistance<Dim>& shape, double diagonal, double max_distance) {
  check(marked);
  const Vec<Dim> y = placement(x);
  if ((y.array() < 0).any() || (y.array() > 1).any())
    throw_input_error("{} lies outside of the domain; are its units and its frame those of the {}?", marked.name(),
                      marked.shape());
  check_distance(marked, std::abs(shape(y)) / diagonal, max_distance);
  return y;
}

}  // namespace

template <int Dim>
std::vector<Landmark<Dim>> exchanged(std::vector<Landmark<Dim>> landmarks) {
  for (Landmark<Dim>& l : landmarks) {
    std::swap(l.on_reference, l.on_template);
    std::swap(l.reference_origin, l.template_origin);
    std::swap(l.reference_name, l.template_name);
  }
  return landmarks;
}

template <int Dim>
void check_landmarks(const std::vector<Landmark<Dim>>& landmarks, const LandmarkOptions& options,
                     const Surface<Dim>& reference, const Surface<Dim>& template_surface) {
  const double diagonal = bounding_box(template_surface.vertices).diagonal();
  for (const bool is_on_reference : {true, false}) {
    const Surface<Dim>& surface = is_on_reference ? reference : template_surface;
    const FacetTree<Dim> tree(surface);
    for (std::size_t l = 0; l < landmarks.size(); ++l) {
      if (l % 1024 == 0) stop_if_wanted();
      const Marked<Dim> marked{landmarks[l], is_on_reference};
      check(marked);
      const Vec<Dim>& x = marked.point();
      check_distance(marked, (closest_point_on_facet<Dim>(surface, tree.nearest(x), x).point - x).norm() / diagonal,
                     options.max_distance);
    }
  }
}

template <int Dim>
PairSet<Dim> landmark_pairs(const std::string& name, const std::vector<Landmark<Dim>>& landmarks,
                            const LandmarkOptions& options, const Similarity<Dim>& pose,
                            const Similarity<Dim>& placement, const SignedDistance<Dim>& reference,
                            const SignedDistance<Dim>& template_shape) {
  const double diagonal = bounding_box(template_shape.surface().vertices).diagonal();
  const double area = surface_measure(reference.surface());
  PairSet<Dim> set;
  set.name = name;
  set.factor = options.weight;
  set.pairs.loss = options.loss;
  set.pairs.scale = options.scale * diagonal;
  for (const Landmark<Dim>& landmark : landmarks) {
    PointPair<Dim> pair;
    pair.p = placed<Dim>({landmark, true}, pose(landmark.on_reference), placement, reference, diagonal,
                         options.max_distance);
    pair.y =
        placed<Dim>({landmark, false}, landmark.on_template, placement, template_shape, diagonal, options.max_distance);
    pair.weight = landmark.weight * area / static_cast<double>(landmarks.size());
    set.pairs.pairs.push_back(pair);
  }
  return set;
}

template std::vector<Landmark<2>> exchanged(std::vector<Landmark<2>>);
template std::vector<Landmark<3>> exchanged(std::vector<Landmark<3>>);
SHELLMATCH_2D_3D(check_landmarks);
SHELLMATCH_2D_3D(landmark_pairs);

}  // namespace shellmatch
