#pragma once
/// \file
/// Trials of starts: how much energy the coarsest levels of a cascade need from there, and how well they cover the
/// template.

#include "alignment/spectrum/limb_ends.h"
#include "matching/alignment/alignment.h"
#include "matching/alignment/kept_results.h"
#include "matching/experiment/options.h"
#include "matching/input/shape_pair.h"
#include "matching/progress/observer.h"

#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

namespace shellmatch {

template <int Dim>
struct CascadeResult;

/// At the end of the coarsest two levels. All infinite where the energy cannot be computed from this start.
struct Trial {
  double energy = std::numeric_limits<double>::infinity();  ///< without the term of the pairs found
  double with_pairs = std::numeric_limits<double>::infinity();
  double template_distance =
      std::numeric_limits<double>::infinity();  ///< mean from the template to phi(M1), diagonals of the template
  std::optional<double> spin_difference = {};   ///< matching/result/spin_difference.h
  double limb_disorder = 0;                     ///< alignment/spectrum/limb_ends.h; 0 for curves and parts

  /// How little alike corresponding places look, as their surroundings and as ends of limbs.
  std::optional<double> unlikeness() const {
    if (!spin_difference) return std::nullopt;
    return *spin_difference * tip_factor(limb_disorder);
  }
};

/// Of a trial of one of both directions. Distance and energy are infinite as above.
struct DirectionTrial {
  double distance = std::numeric_limits<double>::infinity();  ///< sum of the mean distances both ways, diagonals of the
                                                              ///< shape that is not carried
  double energy = std::numeric_limits<double>::infinity();    ///< with all terms
  // Where the shapes lie_near(), both are 0: what ends elsewhere is wrong.
  double missed = 1;         ///< share of the pairs' weight that ends far from where it belongs; 0 without pairs
  double limb_disorder = 0;  ///< as of a Trial
};

/// Outcomes of trials, kept.
struct TrialFindings {
  KeptResults<Trial> starts;
  KeptResults<DirectionTrial> directions;
};

/// Whose distance from the other shape is measured at the end of a trial: phi(M1), or what the inverse of phi makes of
/// M2.
enum class Carried { reference, template_shape };

/// What a terminal shows meanwhile.
inline constexpr const char* trials_activity = "starts are tried";

/// The alignment with the bend of the reference's surface that its pairs and the landmarks tell, as rigid as possible.
/// \param surface of the reference, user's coordinates \pre there are pairs
Alignment<3> bent_start(Alignment<3> alignment, const Surface<3>& surface, const std::vector<Landmark<3>>& landmarks);

/// Tries starts of one matching. Everything given must outlive this object. What trials ask of coarse grids they ask of
/// surfaces with at most 200 000 triangles: larger ones are simplified once.
template <int Dim>
class Trials {
 public:
  /// \param landmarks pull in every trial \param findings takes outcomes, and may have some; null: they are not kept
  Trials(const ShapePair<Dim>& shapes, const std::vector<Landmark<Dim>>& landmarks, const ExperimentOptions& options,
         Observer& observer, TrialFindings* findings = nullptr)
      : shapes_(&shapes), landmarks_(landmarks), options_(options), observer_(observer), findings_(findings) {}

  /// The surfaces that are tried, without the file's own vertices and faces; in the user's coordinates.
  const ShapePair<Dim>& tried_shapes() const;

  /// Those of the template moved onto the reference, with the same copies of the surfaces.
  Trials of_exchanged_shapes() const;

  /// Landmarks have their whole weight, whatever start.landmark_trust.
  Trial operator()(const Alignment<Dim>& start) const;
  /// From the bent reference (bent_start()): the map of a start that no map of space follows is seen
  /// from there. Without pairs the same as above.
  Trial bent(const Alignment<Dim>& start) const;
  /// As the run itself would begin, in its own band: energies compare only where both starts have pairs, or neither
  /// has.
  DirectionTrial of_direction(const Alignment<Dim>& start, Carried carried) const;
  /// Of the shapes as they lie, without pairs; tried once.
  const Trial& as_they_lie();

 private:
  Trial try_start(const Alignment<Dim>& start) const;
  DirectionTrial try_direction(const Alignment<Dim>& start, Carried carried) const;
  double limb_disorder(const Alignment<Dim>& start, const CascadeResult<Dim>& end,
                       const Similarity<Dim>& placement) const;
  template <class Measure>
  void run(const Alignment<Dim>& start, const ExperimentOptions& options, const Measure& measure) const;

  const ShapePair<Dim>* shapes_;
  mutable std::shared_ptr<const ShapePair<Dim>> tried_;  ///< made when first asked for
  std::vector<Landmark<Dim>> landmarks_;
  mutable std::shared_ptr<const std::array<LimbEnds, 2>> limbs_;  ///< of the tried shapes; made when first asked for
  const ExperimentOptions& options_;
  Observer& observer_;
  TrialFindings* findings_;
  std::optional<Trial> as_they_lie_;
};

}  // namespace shellmatch
