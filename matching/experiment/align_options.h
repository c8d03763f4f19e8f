#pragma once
/// \file
/// What is done before a matching so that limbs begin near each other.

#include "alignment/options.h"
#include "base/options.h"

namespace shellmatch {

/// Where pairs of points come from before the cascade, and which motions of the reference may be taken out.
enum class AlignMode { none, automatic, rigid, similarity, landmarks };
template <>
struct EnumNames<AlignMode> {
  static constexpr std::pair<AlignMode, std::string_view> names[] = {{AlignMode::none, "none"},
                                                                     {AlignMode::automatic, "auto"},
                                                                     {AlignMode::rigid, "rigid"},
                                                                     {AlignMode::similarity, "similarity"},
                                                                     {AlignMode::landmarks, "landmarks"}};
};

/// Which of the shapes the energy deforms.
enum class MatchDirection { forward, backward, automatic };
template <>
struct EnumNames<MatchDirection> {
  static constexpr std::pair<MatchDirection, std::string_view> names[] = {{MatchDirection::forward, "forward"},
                                                                          {MatchDirection::backward, "backward"},
                                                                          {MatchDirection::automatic, "auto"}};
};

/// Whether the reference's surface may be bent before the cascade.
enum class BendMode { never, automatic };
template <>
struct EnumNames<BendMode> {
  static constexpr std::pair<BendMode, std::string_view> names[] = {{BendMode::never, "never"},
                                                                    {BendMode::automatic, "auto"}};
};

struct AlignOptions {
  AlignMode mode = AlignMode::automatic;
  MatchDirection direction = MatchDirection::automatic;
  BendMode bend = BendMode::automatic;
  double weight = 10;
  double tolerance = 0.01;
  double coarse_sigma_cells = 1;
  double pose_gain = 2;
  double clear_margin = 1.3;
  double doubtful_score = 0.9;
  double doubtful_margin = 1.02;
  AlignmentOptions search{.pairs = 1000};
  static void describe(auto& self, auto& visit) {
    visit("mode", self.mode,
          {.meaning = "none: the shapes begin as they lie; auto: pairs of points are found and used, unless they are "
                      "no better than none; nothing with input.placement: as-is; rigid, similarity: the reference is "
                      "moved this way and pairs are used, whatever their score; landmarks: it is moved by the "
                      "similarity between the landmarks, nothing is searched"});
    visit("direction", self.direction,
          {.meaning = "forward: the reference is deformed; backward: the template is, and the result is the inverse of "
                      "that map; auto: both are tried on coarse levels if pairs are used, and backward is taken if it "
                      "ends clearly better (docs/alignment.md)"});
    visit("bend", self.bend,
          {.meaning = "auto: if neither direction reaches the pairs (with align.direction: auto), the reference's "
                      "surface is bent by them first, as rigidly as possible, and the map is one of the surface, not "
                      "of space (docs/alignment.md)"});
    visit("weight", self.weight,
          {.min = 0,
           .meaning =
               "factor on the term of the pairs found, which weighs like landmarks; 0: pairs give the pose alone"});
    visit("search", self.search, {.meaning = "the search for pairs (docs/alignment.md)"});
  }
};

}  // namespace shellmatch
