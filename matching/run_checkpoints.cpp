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
EarlierProgress<Dim> RunCheckpoints<Dim>::read(std::size_t n_vertices, const std::string& pictures) {
  if (!folder_) return {};
  std::string obstacle = folder_->obstacle();
  EarlierProgress<Dim> earlier;
  try {
    if (obstacle.empty()) earlier = {folder_->read_alignment<Dim>(), folder_->read<Dim>(n_vertices)};
  } catch (const InputError& error) {
    obstacle = fmt::format("it cannot be read ({})", error.what());
  }
  if (!obstacle.empty())
    recorder_.note(
        fmt::format("{}: {}; the run begins anew{}", folder_->path(), obstacle,
                    folder_->foreign_text().empty() ? " and replaces that folder once it keeps a level" : ""));
  n_findings_ = earlier.findings.size();
  if (earlier.levels) {
    level_ = earlier.levels->summary.levels.back().level;
    recorder_.note(fmt::format("going on after level {}, kept in {} ({:.3g} s of work)", *level_, folder_->path(),
                               earlier.levels->summary.run.seconds));
    folder_->copy_pictures(pictures);
  } else if (n_findings_ > 0) {
    level_ = 0;
    const double seconds = earlier.findings.seconds();
    recorder_.note(fmt::format("going on with what the alignment has found, kept in {} ({:.3g} s of work)",
                               folder_->path(), seconds));
    RunFigures before;
    before.seconds = seconds;
    before.phase_seconds = {{"alignment", seconds}};
    clock_.add_earlier(before);
  }
  return earlier;
}

template <int Dim>
void RunCheckpoints<Dim>::write(const LevelEnd<Dim>& end, const AlignmentFindings<Dim>& findings,
                                const std::string& pictures) {
  if (!folder_ || end.level.last.reason == StopReason::interrupted) return;
  if (clock_.seconds() - last_written_ < options_.min_seconds) return;
  MatchSummary s = end.summary;
  s.interrupted = true;
  s.distance = s.levels.back().distance;
  clock_.state(s.run);
  const int level = end.level.start.level;
  const double begin = clock_.seconds();
  try_to_write(level, fmt::format("level {} is", level), [&] {
    folder_->write<Dim>({end.state.grid, end.state.phi, end.prepared.frame(), end.history, s, end.levels, findings},
                        pictures);
  });
  // Writing runs within the phase output, which therefore counts it too.
  clock_.phases["output"] -= clock_.seconds() - begin;
}

template <int Dim>
void RunCheckpoints<Dim>::write(const AlignmentFindings<Dim>& findings, double least_share) {
  if (!folder_ || findings.size() == n_findings_) return;
  if (findings.seconds() < least_share * options_.min_seconds || folder_->level() > 0) return;
  try_to_write(0, "what the alignment has found is", [&] {
    folder_->write(findings);
    n_findings_ = findings.size();
  });
}

template <int Dim>
void RunCheckpoints<Dim>::remove() {
  if (!folder_ || (!level_ && !folder_->obstacle().empty())) return;
  const std::string text = folder_->foreign_text();
  folder_->remove();
  if (!text.empty()) recorder_.note(fmt::format("{}: {}; that folder is not removed", folder_->path(), text));
}

template <int Dim>
template <class Write>
void RunCheckpoints<Dim>::try_to_write(int level, const std::string& what, const Write& write) {
  const double begin = clock_.seconds();
  const auto note_failure = [&](const std::string& why) {
    recorder_.note(fmt::format("{} not kept for the case that the run is stopped: {}", what, why));
  };
  try {
    write();
    level_ = level;
  } catch (const InputError& error) {
    note_failure(error.what());
  } catch (const EnvironmentError& error) {
    note_failure(error.what());
  } catch (const std::filesystem::filesystem_error& error) {
    note_failure(error.what());
  } catch (const std::bad_alloc&) {
    note_failure("not enough memory");
  }
  last_written_ = clock_.seconds();
  clock_.phases["keeping"] += last_written_ - begin;
}

template class RunCheckpoints<2>;
template class RunCheckpoints<3>;

}  // namespace shellmatch
