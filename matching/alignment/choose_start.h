#pragma once
/// \file
/// The choice among starts of a cascade. Local descriptors have ordered those of surfaces; among those of outlines the
/// energy that a deformation needs chooses. Energies tell nothing of surfaces: they measure how far limbs travel, and
/// half a turn is often the shorter way.

#include "matching/alignment/trial.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace shellmatch {

/// Fewer are no ground for anything.
inline constexpr std::size_t n_least_pairs = 10;

template <int Dim>
struct Start {
  Alignment<Dim> alignment;  ///< without a summary
  std::size_t n_pairs = 0;   ///< found, though they may have no weight
  /// Of the samples of a surface, which the map takes there and back: the rest have no pair.
  std::optional<double> pair_share = {};
  /// The last of alignment.pairs, which contradict those around them: they make the energy of a wrong map's trial
  /// higher, and the one that is chosen is used without them.
  std::size_t n_contradicting = 0;
  double score = 0;   ///< of the pairs, 0 is best: how nearly isometric
  double order = 0;   ///< of surfaces, PairCandidate::order: less is better
  double margin = 1;  ///< of surfaces, PairCandidate::margin: by which factor it is worse than the first
  /// Where landmarks tell: the median distance from where the pairs map them, in roots of the area.
  std::optional<double> landmark_distance = {};
  bool is_identity = false;  ///< began with the shapes as they lie
  bool is_mirrored = false;  ///< found for the mirrored reference

  bool is_usable() const { return n_pairs >= n_least_pairs; }
};

/// What a search found.
template <int Dim>
struct StartSearch {
  /// At least one. The first is the best by score, or as good and preferred, as the shapes as they lie are.
  std::vector<Start<Dim>> starts;
  double margin = 0;  ///< by which factor the next of the same handedness is worse than the first
  /// Landmarks that took part lie all over the template: maps that agree with them are right everywhere.
  bool landmarks_are_spread = false;
  std::size_t n_landmarks = 0;          ///< that took part
  std::vector<std::string> notes = {};  ///< what was left out
  /// Of the area of either shape: below 1 where components were left out.
  double reference_share = 1, template_share = 1;
  /// Of a part and a whole. Whether the shapes as they lie are better, coarse trials do not tell then, as most of the
  /// whole is not reached anyway.
  bool is_of_part = false;
  bool is_ambiguous =
      false;  ///< any rotation may be as good as those that starts stand for: the margin is 1, whatever trials say
  double mirrored_gain = 0;  ///< FoundMaps::mirrored_gain; 0 where none was searched by spectra
  /// Whether the mirrored reference has a map that is much better than a start, as where a left bone lies beside a
  /// right one; empty where none was searched by spectra.
  std::function<bool(const Start<Dim>&)> fits_far_better_mirrored = {};
};

struct StartChoice {
  std::size_t index = 0;
  /// By which factor the others are worse, at least: ratio of scores (with distances of landmarks added) times root of
  /// the ratio of energies for those tried, ratio of scores for the others; infinite without others, 1 where the search
  /// is ambiguous. Others of the other handedness do not count: on a shape that is its own mirror image they are as
  /// good, and right as well.
  double margin = 0;
  std::size_t n_tried = 0;  ///< 0 where the scores were clear enough
  /// Not usable; far from landmarks, where these tell; without landmarks all over the template, by
  /// options.align.doubtful_score or doubtful_margin.
  bool is_doubtful = true;
  /// Such a start may still be better than none.
  bool is_usable = false;
  bool as_it_lies = false;  ///< the shapes as they lie, without pairs, are not clearly worse
};

/// Whether what corresponds looks more alike by a tenth (Trial::unlikeness()).
bool is_more_alike(const Trial& one, const Trial& other);

/// The first usable start, if landmarks all over the template agree with any the first of those; of surfaces whose
/// margin is not clear, the one of the least product of order and score among those close to it (not of parts), and
/// then tries these, from the bent reference where it may bend; another takes its place where what corresponds looks
/// more alike by a tenth (Trial::unlikeness()). Of outlines, tries the first and those whose scores are less than
/// align.clear_margin times the least, if these are several. The start as the outlines lie is preferred by
/// align.search.identity_preference, and by as much any other to a mirrored one. If what is chosen is doubtful, or
/// another than the shapes as they lie and not clearly the best, these are tried without pairs, too, with align.mode
/// auto, and win unless it is better than that by half in energy or in the distance of the template, or what
/// corresponds looks more alike by a tenth (Trial::unlikeness()), or landmarks all over the template agree with it.
template <int Dim>
StartChoice choose_start(const StartSearch<Dim>& search, const AlignOptions& options, Trials<Dim>& trials);

}  // namespace shellmatch
