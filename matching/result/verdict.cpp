#include "matching/result/verdict.h"

#include "alignment/clear_margin.h"
#include "solvers/minimizer.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace shellmatch {

namespace {

// Limits beyond which a figure is unusual, and beyond which the shapes do not match. docs/verdict.md tells on which
// runs they rest.
struct Limits {
  double look, fail;
};
/// Of all figures; lengths in diagonals of the template, shares of the area of the shape that is named, angles in
/// degrees.
struct AllLimits {
  Limits mean_distance, largest_distance;
  Limits unreached;        // share of the template
  Limits flipped;          // share of the reference
  Limits turned_angles;    // 95 % of the area have less
  Limits stretched_areas;  // factor, also against the mean, of 95 % of the area; of lengths in the plane its root
};
constexpr AllLimits usual{{0.005, 0.03}, {0.03, 0.2}, {0.015, 0.05}, {0.02, 0.08}, {20, 48}, {4, 12}};
// Where the map is vouched for: limbs in other poses turn and touch, and the map is right all the same. The less it is
// vouched for, the nearer are its limits to the usual ones.
constexpr AllLimits of_vouched{{0.008, 0.03}, {0.12, 0.25}, {0.06, 0.2}, {0.06, 0.15}, {52, 60}, {5, 12}};
constexpr double alike = 0.4, unlike = 0.5;              // spin differences
constexpr double few_pairs = 0.75, enough_pairs = 0.85;  // shares of the samples
constexpr double much_invented = 0.5;                    // share of a shape's area
// Landmarks set by hand are wrong by less, a landmark on another limb by more.
constexpr Limits landmark_distance{0.05, 0.15};
constexpr double apart = 0.25;  // mean distance in diagonals, before a run
// Shares of the template that no level reaches. Where limbs find their places the share falls by half or more from
// level to level.
constexpr double much_unreached = 0.1, hardly_less = 0.7;

// Two digits without an exponent.
std::string figure_text(double x) { return std::abs(x) < 10 ? fmt::format("{:.2g}", x) : fmt::format("{:.0f}", x); }
std::string percent_text(double share) { return figure_text(100 * share) + " %"; }

// A place to about a thousandth of the template.
std::string place_text(const std::vector<double>& place, const MatchSummary& summary) {
  const double size = summary.template_diagonal.value_or(1);
  const int digits = size > 0 ? std::clamp(static_cast<int>(std::ceil(3 - std::log10(size))), 0, 12) : 3;
  std::vector<std::string> coordinates;
  for (const double x : place) coordinates.push_back(fmt::format("{:.{}f}", x, digits));
  return fmt::format("({})", fmt::join(coordinates, ", "));
}

// What finds a pose: not what has been tried already.
std::string pose_advice(const MatchSummary& summary) {
  const bool was_tried = summary.alignment && summary.alignment->mode != "none";
  return was_tried ? "landmarks (docs/landmarks.md)" : "--align auto or landmarks (docs/landmarks.md)";
}

// Collects reasons; the verdict is that of the gravest.
class Reasons {
 public:
  // NaN is beyond every limit.
  void add(double figure, const Limits& limits, VerdictReason reason) {
    if (figure <= limits.look) return;
    (figure <= limits.fail ? look_ : fail_).push_back(std::move(reason));
  }
  void fail(VerdictReason reason) { fail_.push_back(std::move(reason)); }
  void look(VerdictReason reason) { look_.push_back(std::move(reason)); }

  Verdict verdict() && {
    Verdict v{fail_.empty() ? look_.empty() ? "matched" : "look-here" : "not-matched", std::move(fail_)};
    v.reasons.insert(v.reasons.end(), std::make_move_iterator(look_.begin()), std::make_move_iterator(look_.end()));
    return v;
  }

 private:
  std::vector<VerdictReason> look_, fail_;
};

// How far a map is vouched for, from 0 to 1: a search has found it nearly isometric and better than any other, for 1
// clearly so, nearly all samples have a pair, and what corresponds in the end looks alike, all to some degree.
// Exchanged sides look alike, too, but are not clearly better or worse than the right ones. Where limbs go wrong,
// samples on them have no pair.
double vouched_share(const MatchSummary& summary) {
  const auto& a = summary.alignment;
  const bool is_sound = a && !a->doubtful && !a->as_it_lies && a->n_pairs > 0 && a->score &&
                        *a->score <= nearly_isometric && summary.spin_difference && *summary.spin_difference < unlike;
  if (!is_sound) return 0;
  const bool one_is_part = summary.reference.may_be_part() || summary.template_shape.may_be_part();
  const double clear = one_is_part ? clear_margin_of_part : clear_margin;
  return std::clamp(std::min({(a->margin.value_or(clear) - 1) / (clear - 1),
                              (a->pair_share.value_or(1) - few_pairs) / (enough_pairs - few_pairs),
                              (unlike - *summary.spin_difference) / (unlike - alike)}),
                    0.0, 1.0);
}

AllLimits limits_for(double vouched) {
  const auto between = [vouched](const Limits& a, const Limits& b) {
    return Limits{std::lerp(a.look, b.look, vouched), std::lerp(a.fail, b.fail, vouched)};
  };
  const AllLimits &a = usual, &b = of_vouched;
  return {between(a.mean_distance, b.mean_distance), between(a.largest_distance, b.largest_distance),
          between(a.unreached, b.unreached),         between(a.flipped, b.flipped),
          between(a.turned_angles, b.turned_angles), between(a.stretched_areas, b.stretched_areas)};
}

// What a part lacks does not reach the other shape: worth a look the less the map is vouched for, and no failure.
Limits limits_beside(const ShapeSummary& shape, Limits limits, double vouched) {
  constexpr double none = std::numeric_limits<double>::infinity();
  if (shape.may_be_part()) limits = {vouched < 1 ? limits.look / (1 - vouched) : none, none};
  return limits;
}

void judge_distances(const MatchSummary& summary, const VerdictPlaces& places, Reasons& reasons) {
  if (!summary.distance) return;
  const auto& [there, back, uncovered] = *summary.distance;
  if (std::isnan(there.mean) || std::isnan(back.mean)) {
    reasons.fail({"nothing was measured: what the one shape has, the other lacks",
                  "do they lie in one place (shellmatch inspect)?",
                  "",
                  {}});
    return;
  }
  const double vouched = vouched_share(summary);
  const AllLimits limits = limits_for(vouched);
  // Of a whole the mean is over much that its part lacks; of two parts over what both have.
  const auto mean_limits = [&](const ShapeSummary& other, const ShapeSummary& own) {
    return own.may_be_part() ? limits.mean_distance : limits_beside(other, limits.mean_distance, vouched);
  };
  const std::string whole =
      "are units and poses the same (shellmatch inspect), are both shapes whole and of one kind? Otherwise " +
      pose_advice(summary);
  reasons.add(
      there.mean, mean_limits(summary.template_shape, summary.reference),
      {fmt::format("the deformed reference lies {} from the template on average", length_text(there.mean, summary)),
       whole, "deformed", places.deformed});
  reasons.add(
      back.mean, mean_limits(summary.reference, summary.template_shape),
      {fmt::format("the template lies {} from the deformed reference on average", length_text(back.mean, summary)),
       whole, "template", places.template_shape});
  if (uncovered)
    reasons.add(*uncovered, limits_beside(summary.reference, limits.unreached, vouched),
                {percent_text(*uncovered) + " of the template is not reached",
                 pose_advice(summary) + " can tell where to go", "template", places.template_shape});
  reasons.add(
      there.max, limits_beside(summary.template_shape, limits.largest_distance, vouched),
      {fmt::format("a part of the deformed reference lies {} from the template", length_text(there.max, summary)),
       "the template may lack it, or a finer level (--levels) may be needed", "deformed", places.deformed});
  reasons.add(
      back.max, limits_beside(summary.reference, limits.largest_distance, vouched),
      {fmt::format("a part of the template lies {} from the deformed reference", length_text(back.max, summary)),
       "the reference may lack it; otherwise a finer level or landmarks help", "template", places.template_shape});
}

void judge_distortion(const MatchSummary& summary, const VerdictPlaces& places, Reasons& reasons) {
  const std::string wrong =
      "where that is not what the shapes are like, points correspond wrongly: " + pose_advice(summary);
  const AllLimits limits = limits_for(vouched_share(summary));
  if (summary.flipped_share)
    reasons.add(*summary.flipped_share, limits.flipped,
                {fmt::format("{} of the {} faces away from the template next to it",
                             percent_text(*summary.flipped_share), summary.dimension == 2 ? "curve" : "surface"),
                 "look at the pictures; the parts may belong to different limbs",
                 "",
                 {}});
  if (summary.angle_distortion && summary.angle_distortion->p95)
    reasons.add(*summary.angle_distortion->p95, limits.turned_angles,
                {fmt::format("directions on a twentieth of the surface turn by more than {:.0f} degrees",
                             *summary.angle_distortion->p95),
                 wrong, "deformed", places.distorted});
  if (const auto& area = summary.area_distortion; area && area->p5 && area->p95) {
    const auto factor_against = [&](double size) { return std::max(*area->p95 / size, size / *area->p5); };
    // Another size of the whole distorts nothing.
    const double factor = std::min(factor_against(1), factor_against(area->mean));
    reasons.add(summary.dimension == 2 ? factor * factor : factor, limits.stretched_areas,
                {fmt::format("{} change by a factor of more than {} on a twentieth of the {}",
                             summary.dimension == 2 ? "lengths" : "areas", figure_text(factor),
                             summary.dimension == 2 ? "curve" : "surface"),
                 wrong, "deformed", places.distorted});
  }
  if (!summary.levels.empty() && summary.levels.back().folds.n_folded_cells > 0)
    reasons.look({fmt::format("folded cells of the grid: {}", summary.levels.back().folds.n_folded_cells),
                  "the profile default forbids folds",
                  "",
                  {}});
}

void judge_landmarks(const MatchSummary& summary, Reasons& reasons) {
  if (!summary.landmarks) return;
  const LandmarkSummary& l = *summary.landmarks;
  const std::string name = l.n == 1 ? fmt::format("landmark {}", l.farthest)
                                    : fmt::format("landmark {}, the farthest of {},", l.farthest, l.n);
  reasons.add(l.mean, landmark_distance,
              {fmt::format("landmarks end {} from where they belong on average", length_text(l.mean, summary)),
               "are their names and order the same on both shapes? Otherwise a larger landmarks.weight helps",
               "template", l.place});
  if (l.mean > landmark_distance.look) return;
  if (l.max > landmark_distance.look)
    reasons.look({fmt::format("{} ends {} from where it belongs", name, length_text(l.max, summary)),
                  "is it the same point on both shapes?", "template", l.place});
}

void judge_kinds(const MatchSummary& summary, Reasons& reasons) {
  const ShapeSummary &a = summary.reference, &b = summary.template_shape;
  // What a part has of either tells nothing about the whole. Limbs that touch in one pose do not spoil a clear map.
  const bool are_wholes = !a.may_be_part() && !b.may_be_part();
  const bool has_other_handles = a.genus != b.genus && vouched_share(summary) < 1;
  if (are_wholes && a.n_components && b.n_components && (a.n_components != b.n_components || has_other_handles))
    reasons.look(
        {fmt::format("the reference has {} component{} and genus {}, the template {} and {}", *a.n_components,
                     *a.n_components == 1 ? "" : "s", a.genus.value_or(0), *b.n_components, b.genus.value_or(0)),
         "a map without tears cannot make one from the other: holes and parts that one shape lacks are bridged or "
         "squeezed; remove what is no part of the shape, such as the floor of a scan",
         "",
         {}});
  for (const auto& [shape, name] : {std::pair{&a, "reference"}, std::pair{&b, "template"}})
    if (shape->invented && *shape->invented > much_invented)
      reasons.look({fmt::format("{} of the {}'s surface was made up to close it", percent_text(*shape->invented), name),
                    "that part weighs nothing, and little else is left; --strict refuses such files (docs/closing.md)",
                    "",
                    {}});
  if (summary.alignment && summary.alignment->doubtful)
    reasons.look({"the alignment has found no pose that is clearly the best",
                  "compare with landmarks (docs/landmarks.md)",
                  "",
                  {}});
  if (summary.alignment && summary.alignment->fits_mirrored)
    reasons.look({"the mirrored reference fits far better",
                  "is one of the shapes of the other side? --set align.search.mirror=true mirrors it",
                  "",
                  {}});
  if (!summary.levels.empty() && summary.levels.back().stop_reason == enum_name(StopReason::cannot_evaluate_start))
    reasons.look({fmt::format("nothing was minimised on level {}: {}", summary.levels.back().level,
                              summary.levels.back().stop_message),
                  "other weights (energy.*) or levels may help",
                  "",
                  {}});
  if (summary.interrupted)
    reasons.look({"the run was stopped before its last level", "the same command goes on", "", {}});
}

}  // namespace

std::string length_text(double diagonals, const MatchSummary& summary) {
  const std::string relative = fmt::format("{:.2g} diagonals", diagonals);
  if (!summary.template_diagonal) return relative;
  const std::string unit = summary.unit.value_or("");
  const double length = diagonals * *summary.template_diagonal;
  const std::string text =
      length >= 1000 && length < 1e9 ? fmt::format("{:.0f}", length) : fmt::format("{:.3g}", length);
  return fmt::format("{}{}{} ({})", text, unit.empty() ? "" : " ", unit, relative);
}

Verdict judge(const MatchSummary& summary, const VerdictPlaces& places) {
  Reasons reasons;
  judge_distances(summary, places, reasons);
  judge_distortion(summary, places, reasons);
  judge_landmarks(summary, reasons);
  judge_kinds(summary, reasons);
  return std::move(reasons).verdict();
}

std::vector<std::string> verdict_lines(const MatchSummary& summary) {
  std::vector<std::string> lines;
  if (summary.distance) {
    const auto& [there, back, uncovered] = *summary.distance;
    const auto text = [&](const OneSidedDistance& d) {
      if (std::isnan(d.mean)) return std::string("not measured, as there is nothing");
      return fmt::format("mean {}, 95 % {}, largest {}", length_text(d.mean, summary), length_text(d.p95, summary),
                         length_text(d.max, summary));
    };
    const char* where = summary.reference.is_measured_everywhere() && summary.template_shape.is_measured_everywhere()
                            ? ""
                            : " where both have data";
    lines.push_back(fmt::format("distance of the deformed reference from the template{}: {}", where, text(there)));
    lines.push_back(fmt::format("distance of the template from the deformed reference{}: {}", where, text(back)));
    if (uncovered && !std::isnan(*uncovered))
      lines.back() += fmt::format("; {} is not reached", percent_text(*uncovered));
  }
  if (summary.landmarks)
    lines.push_back(fmt::format("landmarks: {} end {} from where they belong on average, at most {} ({})",
                                summary.landmarks->n, length_text(summary.landmarks->mean, summary),
                                length_text(summary.landmarks->max, summary), summary.landmarks->farthest));
  if (!summary.verdict) return lines;
  const Verdict& v = *summary.verdict;
  lines.push_back(v.outcome == "matched"     ? "verdict: matched"
                  : v.outcome == "look-here" ? "verdict: matched, but look here"
                                             : "verdict: not matched");
  for (const VerdictReason& r : v.reasons)
    lines.push_back(fmt::format("  {}{}; {}", r.what,
                                r.place.empty() ? ""
                                                : fmt::format(", near {} of the {}", place_text(r.place, summary),
                                                              r.shape == "deformed" ? "deformed reference" : r.shape),
                                r.advice));
  return lines;
}

std::optional<std::string> far_apart_warning(const MatchSummary& summary) {
  if (!summary.distance_before) return std::nullopt;
  const double back = summary.distance_before->template_to_deformed.mean,
               there = summary.distance_before->deformed_to_template.mean;
  // Nothing is measured then, but phi may still bring them together.
  if (std::isnan(there) || std::isnan(back))
    return "nothing that both shapes have lies side by side: where the one is, the other has gaps; do they lie in one "
           "place (shellmatch inspect)?";
  if (std::max(there, back) <= apart) return std::nullopt;
  return fmt::format(
      "the shapes begin far apart: the reference lies {} from the template on average, the template {} from the "
      "reference; are units "
      "and places the same (shellmatch inspect)? Otherwise {}",
      length_text(there, summary), length_text(back, summary), pose_advice(summary));
}

std::optional<std::string> stuck_warning(const std::vector<LevelSummary>& levels) {
  if (levels.size() < 3) return std::nullopt;
  const auto uncovered = [](const LevelSummary& level) {
    return level.distance ? level.distance->uncovered.value_or(0) : 0;
  };
  const double before = uncovered(levels[levels.size() - 2]), now = uncovered(levels.back());
  if (!(now > much_unreached && now > hardly_less * before)) return std::nullopt;
  return fmt::format(
      "level {}: {:.0f} % of the template is not reached, after {:.0f} % on the level before, and finer levels will "
      "hardly reach more: "
      "the shapes begin too far apart there, or are of different kinds; landmarks can tell where to go "
      "(docs/landmarks.md)",
      levels.back().level, 100 * now, 100 * before);
}

}  // namespace shellmatch
