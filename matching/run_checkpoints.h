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

template <int Dim>
class RunCheckpoints {
 public:
  /// Without open() there are none, and all functions do nothing. \pre the arguments outlive this
  RunCheckpoints(const ResumeOptions& options, Recorder& recorder, RunClock& clock)
      : options_(options), recorder_(recorder), clock_(clock), last_written_(clock.seconds()) {}

  /// \param output absolute path of the output folder
  void open(const std::string& output, RunIdentity identity);

  /// What an earlier run of the same identity had reached, if it has left a checkpoint; its pictures are copied.
  /// \param n_vertices of the reference's surface \param pictures folder of this run's pictures
  std::optional<MatchProgress<Dim>> read(std::size_t n_vertices, const std::string& pictures);

  /// Writes one, unless the last is younger than resume.min_seconds.
  void write(const LevelEnd<Dim>& end, const std::string& pictures);

  /// After the output has been written. The checkpoint of another configuration stays, unless this run has replaced it.
  void remove();

  /// The level of the last one, read or written; 0: there is none.
  int level() const { return level_; }
  /// \pre level() > 0
  const std::string& path() const { return folder_->path(); }

 private:
  void note_failure(int level, const std::string& why);

  const ResumeOptions& options_;
  Recorder& recorder_;
  RunClock& clock_;
  std::optional<CheckpointFolder> folder_;
  int level_ = 0;
  double last_written_;  ///< seconds of the run
};

}  // namespace shellmatch
