#include "matching/alignment/choose_start.h"

#include "alignment/clear_margin.h"
#include "base/stop.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace shellmatch {

namespace {

// Shapes that lie as they belong may resemble each other more after half a turn, as two bent tori do. Another start has
// to be better by this factor, in energy or in distance,
constexpr double clearly_better = 1.5;
// or what corresponds has to look more alike by this one: limbs in another pose cost energy, and yet they are the same
// limbs.
constexpr double clearly_more_alike = 1.1;

// In roots of the area.
constexpr double most_landmark_distance = 0.15;

template <int Dim>
class Choosing {
 public:
  Choosing(const StartSearch<Dim>& search, const AlignOptions& options, Trials<Dim>& trials)
      : starts_(search.starts),
        landmarks_are_spread_(search.landmarks_are_spread),
        is_ambiguous_(search.is_ambiguous),
        is_of_part_(search.is_of_part),
        options_(options),
        try_(trials),
        trials_(starts_.size()),
        bent_trials_(starts_.size()) {
    for (std::size_t i = 0; i < starts_.size(); ++i)
      if (starts_[i].is_usable()) usable_.push_back(i);
  }

  StartChoice go(double margin) {
    StartChoice choice;
    choice.margin = margin;
    if (usable_.empty()) return choice;
    choice.index = usable_.front();
    if (const auto agreed = std::ranges::find_if(usable_, [&](std::size_t i) { return landmarks_confirm(starts_[i]); });
        agreed != usable_.end())
      choice.index = *agreed;
    if constexpr (Dim == 2)
      if (const std::vector<std::size_t> close = close_ones(); close.size() > 1) among(close, choice);
    if constexpr (Dim == 3)
      if (options_.mode == AlignMode::automatic && margin < clear_margin && !is_ambiguous_ && !is_of_part_ &&
          !landmarks_confirm(starts_[choice.index]))
        by_likeness(choice);
    if (is_ambiguous_) choice.margin = 1;
    const Start<Dim>& best = starts_[choice.index];
    choice.is_doubtful = is_doubtful(best, choice.margin);
    // What landmarks contradict, and what any rotation may replace, is no start.
    choice.is_usable = !is_ambiguous_ && !landmarks_contradict(best);
    const bool is_clear =
        is_of_part_ ? best.score <= options_.doubtful_score
                    : !choice.is_doubtful &&
                          (best.is_identity || (Dim == 3 && choice.margin >= clear_margin) || landmarks_confirm(best));
    if (options_.mode == AlignMode::automatic && choice.is_usable && !is_clear)
      choice.as_it_lies = !is_clearly_better(trial(choice.index), try_.as_they_lie()) &&
                          !(bends() && is_more_alike(bent_trial(choice.index), try_.as_they_lie()));
    return choice;
  }

 private:
  // Landmarks say better than scores whether pairs are right: those all over the shape alone, those on one part of it
  // that they are wrong.
  bool is_doubtful(const Start<Dim>& start, double margin) const {
    if (landmarks_confirm(start)) return false;
    if (landmarks_contradict(start)) return true;
    return start.score > options_.doubtful_score || margin < options_.doubtful_margin;
  }

  static bool landmarks_contradict(const Start<Dim>& start) {
    return start.landmark_distance && *start.landmark_distance > most_landmark_distance;
  }

  // Landmarks all over the shape tell a turn by which it resembles itself from where it belongs.
  bool landmarks_confirm(const Start<Dim>& start) const {
    return landmarks_are_spread_ && start.landmark_distance && *start.landmark_distance <= most_landmark_distance;
  }

  std::vector<std::size_t> close_ones() const {
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t i : usable_) least = std::min(least, starts_[i].score);
    std::vector<std::size_t> close;
    for (const std::size_t i : usable_)
      if (i == usable_.front() || starts_[i].score < options_.clear_margin * least) close.push_back(i);
    return close;
  }

  void among(const std::vector<std::size_t>& close, StartChoice& choice) {
    // The least is best. Scores are relative distances, energies squares of such, of which a coarse grid may err by a
    // fifth.
    std::vector<double> merit(starts_.size());
    Activity trying(trials_activity, close.size());
    for (const std::size_t i : close) {
      trying.next();
      merit[i] = (starts_[i].score + starts_[i].landmark_distance.value_or(0)) * std::sqrt(trial(i).with_pairs);
    }
    const auto preferred = [&](std::size_t i) {
      const double factor = options_.search.identity_preference;
      return starts_[i].is_identity ? merit[i] / factor : starts_[i].is_mirrored ? merit[i] * factor : merit[i];
    };
    const std::size_t best =
        *std::min_element(close.begin(), close.end(), [&](auto a, auto b) { return preferred(a) < preferred(b); });
    choice.n_tried = close.size();
    if (!std::isfinite(merit[best])) return;
    choice.index = best;
    choice.margin = std::numeric_limits<double>::infinity();
    for (const std::size_t i : usable_)
      if (i != best && starts_[i].is_mirrored == starts_[best].is_mirrored)
        choice.margin =
            std::min(choice.margin, trials_[i] ? merit[i] / merit[best] : starts_[i].score / starts_[best].score);
  }

  // Where descriptors on the surfaces leave it open, it counts as well how nearly isometric a map is, and then the
  // likeness of what corresponds after a trial decides. Parts look alike wherever they are bent to, so that their maps
  // are not tried.
  void by_likeness(StartChoice& choice) {
    const Start<Dim>& first = starts_[choice.index];
    std::vector<std::size_t> close;
    for (const std::size_t i : usable_)
      if (i == choice.index || (starts_[i].margin < clear_margin && starts_[i].is_mirrored == first.is_mirrored))
        close.push_back(i);
    if (close.size() == 1) return;
    choice.index = *std::ranges::min_element(close, {}, [&](auto i) { return starts_[i].order * starts_[i].score; });
    std::erase(close, choice.index);
    choice.n_tried = 1 + close.size();
    Activity trying(trials_activity, choice.n_tried);
    const auto difference = [&](std::size_t i) {
      trying.next();
      return (bends() ? bent_trial(i) : trial(i)).unlikeness().value_or(std::numeric_limits<double>::infinity());
    };
    double least = difference(choice.index) / clearly_more_alike;
    for (const std::size_t i : close) {
      if (difference(i) >= least) continue;
      least = difference(i);
      choice.index = i;
    }
  }

  static bool is_clearly_better(const Trial& chosen, const Trial& none) {
    return clearly_better * chosen.energy < none.energy ||
           clearly_better * chosen.template_distance < none.template_distance || is_more_alike(chosen, none);
  }

  bool bends() const { return Dim == 3 && !is_of_part_ && options_.bend != BendMode::never; }

  const Trial& trial(std::size_t i) {
    if (!trials_[i]) trials_[i] = try_(starts_[i].alignment);
    return *trials_[i];
  }

  const Trial& bent_trial(std::size_t i) {
    if (!bent_trials_[i]) bent_trials_[i] = try_.bent(starts_[i].alignment);
    return *bent_trials_[i];
  }

  const std::vector<Start<Dim>>& starts_;
  const bool landmarks_are_spread_, is_ambiguous_, is_of_part_;
  const AlignOptions& options_;
  Trials<Dim>& try_;
  std::vector<std::optional<Trial>> trials_, bent_trials_;
  std::vector<std::size_t> usable_;
};

}  // namespace

// A bent surface lies near the template whatever the map, and needs little energy: its likeness alone tells.
bool is_more_alike(const Trial& one, const Trial& other) {
  const auto a = one.unlikeness(), b = other.unlikeness();
  return a && b && clearly_more_alike * *a < *b;
}

template <int Dim>
StartChoice choose_start(const StartSearch<Dim>& search, const AlignOptions& options, Trials<Dim>& trials) {
  return Choosing<Dim>(search, options, trials).go(search.margin);
}

SHELLMATCH_2D_3D(choose_start);

}  // namespace shellmatch
