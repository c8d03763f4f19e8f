#pragma once
/// \file
/// The checkpoints of one run of the program: which it resumes from, when it writes one and when it removes it. What
/// stands in the way is told as a note and ends no run, which may never need a checkpoint.

#include "matching/checkpoint/checkpoints.h"
#include "matching/match_placed_shapes.h"

#include <cstddef>
#include <optional>
#include <string>

namespace shellmatch {

/// What a run begins with.
template <int Dim>
struct EarlierProgress {
  AlignmentFindings<Dim> findings;
  std::optional<MatchProgress<Dim>> levels;
};

template <int Dim>
class RunCheckpoints {
 public:
  /// Without open() there are none, and all functions do nothing. \pre the arguments outlive this
  RunCheckpoints(const ResumeOptions& options, Recorder& recorder, RunClock& clock)
      : options_(options), recorder_(recorder), clock_(clock), last_written_(clock.seconds()) {}

  /// \param output absolute path of the output folder
  void open(const std::string& output, RunIdentity identity);

  bool is_open() const { return folder_.has_value(); }

  /// What an earlier run of the same identity had reached, if it has left a checkpoint; its pictures are copied.
  /// \param n_vertices of the reference's surface \param pictures folder of this run's pictures
  EarlierProgress<Dim> read(std::size_t n_vertices, const std::string& pictures);

  /// Writes one, unless the last is younger than resume.min_seconds.
  void write(const LevelEnd<Dim>& end, const AlignmentFindings<Dim>& findings, const std::string& pictures);

  /// Writes what the alignment has found so far, if that took `least_share` of resume.min_seconds. A checkpoint after a
  /// level stays, also one of another experiment.
  void write(const AlignmentFindings<Dim>& findings, double least_share);

  /// After the output has been written. The checkpoint of another configuration stays, unless this run has replaced it.
  void remove();

  /// The level of the last one, read or written, 0 before the first; none where there is none.
  std::optional<int> level() const { return level_; }
  /// \pre level()
  const std::string& path() const { return folder_->path(); }

 private:
  template <class Write>
  void try_to_write(int level, const std::string& what, const Write& write);

  const ResumeOptions& options_;
  Recorder& recorder_;
  RunClock& clock_;
  std::optional<CheckpointFolder> folder_;
  std::optional<int> level_;
  std::size_t n_findings_ = 0;  ///< in the last one
  double last_written_;         ///< seconds of the run
};

}  // namespace shellmatch
