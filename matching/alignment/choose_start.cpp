#include "matching/alignment/choose_start.h"

#include "matching/alignment/trial.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace shellmatch {

namespace {

// Shapes that lie as they belong may resemble each other more after half a turn, as two bent tori do. Another start has to be
// better by this factor, in energy or in coverage.
constexpr double clearly_better = 1.5;

template <int Dim>
class Choosing {
 public:
  Choosing(const ShapePair<Dim>& shapes, const std::vector<Start<Dim>>& starts, const std::vector<Landmark<Dim>>& landmarks,
           const ExperimentOptions& options, Observer& observer)
      : shapes_(shapes), starts_(starts), landmarks_(landmarks), options_(options), observer_(observer), trials_(starts.size()) {}

  StartChoice go(double margin) {
    StartChoice choice;
    choice.margin = margin;
    std::vector<std::size_t> close;
    for (std::size_t i = 0; i < starts_.size(); ++i)
      if (starts_[i].score < options_.align.clear_margin * starts_[0].score && starts_[i].n_pairs >= min_pairs)
        close.push_back(i);
    if (close.size() > 1 && options_.align.weight > 0) among(close, choice);
    const Start<Dim>& best = starts_[choice.index];
    const AlignOptions& o = options_.align;
    choice.is_doubtful = !(best.n_pairs >= min_pairs && best.score <= o.doubtful_score && choice.margin >= o.doubtful_margin);
    if (o.mode == AlignMode::automatic && !choice.is_doubtful && !best.is_identity)
      choice.as_it_lies = !is_clearly_better_than_none(trial(choice.index));
    return choice;
  }

 private:
  void among(const std::vector<std::size_t>& close, StartChoice& choice) {
    std::vector<double> merit(starts_.size());  // the least is best
    for (std::size_t i = 0; i < starts_.size(); ++i) merit[i] = starts_[i].score;
    for (const std::size_t i : close) merit[i] = std::sqrt(starts_[i].score * trial(i).with_pairs);
    const auto preferred = [&](std::size_t i) {
      return starts_[i].is_identity ? merit[i] / std::sqrt(options_.align.search.identity_preference) : merit[i];
    };
    const std::size_t best =
        *std::min_element(close.begin(), close.end(), [&](auto a, auto b) { return preferred(a) < preferred(b); });
    choice.n_tried = close.size();
    if (!std::isfinite(merit[best])) return;
    choice.index = best;
    choice.margin = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < starts_.size(); ++i)
      if (i != best)
        choice.margin = std::min(choice.margin, trials_[i] ? merit[i] / merit[best] : starts_[i].score / starts_[best].score);
  }

  bool is_clearly_better_than_none(const Trial& chosen) const {
    const Trial none = try_start<Dim>(shapes_, {}, landmarks_, options_, observer_);
    return clearly_better * chosen.energy < none.energy || clearly_better * chosen.uncovered < none.uncovered;
  }

  const Trial& trial(std::size_t i) {
    if (!trials_[i]) trials_[i] = try_start(shapes_, starts_[i].alignment, landmarks_, options_, observer_);
    return *trials_[i];
  }

  const ShapePair<Dim>& shapes_;
  const std::vector<Start<Dim>>& starts_;
  const std::vector<Landmark<Dim>>& landmarks_;
  const ExperimentOptions& options_;
  Observer& observer_;
  std::vector<std::optional<Trial>> trials_;
};

}  // namespace

template <int Dim>
StartChoice choose_start(const ShapePair<Dim>& shapes, const std::vector<Start<Dim>>& starts, double margin,
                         const std::vector<Landmark<Dim>>& landmarks, const ExperimentOptions& options, Observer& observer) {
  return Choosing<Dim>(shapes, starts, landmarks, options, observer).go(margin);
}

template StartChoice choose_start<2>(const ShapePair<2>&, const std::vector<Start<2>>&, double, const std::vector<Landmark<2>>&, const ExperimentOptions&, Observer&);
template StartChoice choose_start<3>(const ShapePair<3>&, const std::vector<Start<3>>&, double, const std::vector<Landmark<3>>&, const ExperimentOptions&, Observer&);

}  // namespace shellmatch
