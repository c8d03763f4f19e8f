#include "matching/run_checkpoints.h"

#include "base/error.h"

#include <filesystem>
#include <new>
#include <utility>

namespace shellmatch {

template <int Dim>
void RunCheckpoints<Dim>::open(const std::string& output, RunIdentity identity) {
  constexpr const char* consequence = "levels are not kept for the case that this run is stopped";
  try {
    folder_.emplace(output, std::move(identity));
  } catch (const EnvironmentError& error) {
    return recorder_.note(fmt::format("{}: {}", consequence, error.what()));
  }
  if (folder_->is_foreign()) {
    recorder_.note(fmt::format("{}: no run has written this, and it is left alone: {}", folder_->path(), consequence));
    folder_.reset();
  } else if (const std::string text = folder_->foreign_text(); !text.empty()) {
    recorder_.note(fmt::format("{}: {}; until that is moved elsewhere, {}", folder_->path(), text, consequence));
  }
}

template <int Dim>
std::optional<MatchProgress<Dim>> RunCheckpoints<Dim>::read(std::size_t n_vertices, const std::string& pictures) {
  if (!folder_) return std::nullopt;
  std::string obstacle = folder_->obstacle();
  std::optional<MatchProgress<Dim>> checkpoint;
  try {
    if (obstacle.empty()) checkpoint = folder_->read<Dim>(n_vertices);
  } catch (const InputError& error) {
    obstacle = fmt::format("it cannot be read ({})", error.what());
  }
  if (!obstacle.empty())
    recorder_.note(
        fmt::format("{}: {}; the run begins anew{}", folder_->path(), obstacle,
                    folder_->foreign_text().empty() ? " and replaces that folder once it keeps a level" : ""));
  if (!checkpoint) return std::nullopt;
  level_ = checkpoint->summary.levels.back().level;
  recorder_.note(fmt::format("going on after level {}, kept in {} ({:.3g} s of work)", level_, folder_->path(),
                             checkpoint->summary.run.seconds));
  folder_->copy_pictures(pictures);
  return checkpoint;
}

template <int Dim>
void RunCheckpoints<Dim>::write(const LevelEnd<Dim>& end, const std::string& pictures) {
  if (!folder_ || end.level.last.reason == StopReason::interrupted) return;
  const double begin = clock_.seconds();
  if (begin - last_written_ < options_.min_seconds) return;
  MatchSummary s = end.summary;
  s.interrupted = true;
  s.distance = s.levels.back().distance;
  clock_.state(s.run);
  const int level = end.level.start.level;
  try {
    folder_->write<Dim>({end.state.grid, end.state.phi, end.prepared.frame(), end.history, s, end.levels}, pictures);
    level_ = level;
  } catch (const InputError& error) {
    note_failure(level, error.what());
  } catch (const EnvironmentError& error) {
    note_failure(level, error.what());
  } catch (const std::filesystem::filesystem_error& error) {
    note_failure(level, error.what());
  } catch (const std::bad_alloc&) {
    note_failure(level, "not enough memory");
  }
  last_written_ = clock_.seconds();
  clock_.phases["keeping"] += last_written_ - begin;
  // Writing runs within the phase output, which therefore counts it too.
  clock_.phases["output"] -= last_written_ - begin;
}

template <int Dim>
void RunCheckpoints<Dim>::remove() {
  if (!folder_ || (level_ == 0 && !folder_->obstacle().empty())) return;
  const std::string text = folder_->foreign_text();
  folder_->remove();
  if (!text.empty()) recorder_.note(fmt::format("{}: {}; that folder is not removed", folder_->path(), text));
}

template <int Dim>
void RunCheckpoints<Dim>::note_failure(int level, const std::string& why) {
  recorder_.note(fmt::format("level {} is not kept for the case that the run is stopped: {}", level, why));
}

template class RunCheckpoints<2>;
template class RunCheckpoints<3>;

}  // namespace shellmatch
