#pragma once
/// \file
/// What a run keeps of its finished levels, so that the same command goes on where it was stopped or killed: the folder
/// NAME.unfinished beside the output folder NAME.

#include "geometry/surface/surface.h"
#include "matching/cascade/deformation.h"
#include "matching/output/history_file.h"
#include "matching/experiment/options.h"
#include "matching/output/summary.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace shellmatch {

/// All that the levels of a run depend on.
struct RunIdentity {
  ExperimentOptions options;
  /// Checksums of both shapes as they lie in the unit domain: what is in a file counts, not its name.
  std::string reference, template_shape;
  std::string program;  ///< version, compiler and checksum of what is being executed: another build has other last digits
};

template <int Dim>
RunIdentity run_identity(const ExperimentOptions& options, const Surface<Dim>& reference,
                         const Surface<Dim>& template_shape);

/// The map at the end of a level and all that was told until then.
template <int Dim>
struct Checkpoint {
  Deformation<Dim> deformation;
  History history;
  MatchSummary summary;  ///< `levels`, `gradient_checks` and `run`, with the times until then
};

/// The same while the run goes on.
template <int Dim>
struct CheckpointView {
  const Octree<Dim>& grid;
  const std::vector<Vec<Dim>>& phi;
  const Similarity<Dim>& placement;
  const History& history;
  const MatchSummary& summary;
};

/// The folder in which finished levels are kept. It looks like an output folder, except that it holds no deformed shape;
/// `apply` takes it. It is replaced as a whole after every level, so that a kill at any moment leaves one or the other.
class CheckpointFolder {
 public:
  /// Removes what a killed run was writing. \param output the absolute path of the run's output folder
  CheckpointFolder(const std::string& output, RunIdentity identity);

  const std::string& path() const { return path_; }

  /// Has something else that name? Then nothing can be kept.
  bool is_foreign() const;

  /// Why a run does not go on with what is kept: empty where it can, or where there is nothing; else "its template is
  /// another one" or "its history.csv is damaged". \pre not is_foreign()
  std::string obstacle() const;

  /// What is kept, if anything. \pre obstacle() is empty \throws InputError for what is whole and yet no such state
  template <int Dim>
  std::optional<Checkpoint<Dim>> read() const;

  /// \param pictures the folder of the run's pictures so far
  /// \throws EnvironmentError if it cannot be written: what was kept before then stays. \pre not is_foreign()
  template <int Dim>
  void write(const CheckpointView<Dim>& checkpoint, const std::string& pictures);

  /// Brings the pictures of the kept levels into a new run's folder. \throws EnvironmentError
  void copy_pictures(const std::string& pictures) const;

  /// The run has written its output: nothing is needed any more.
  void remove();

 private:
  bool is_ours() const;

  std::string path_;
  RunIdentity identity_;
};

/// Contents of the file that tells a kept state from any other folder.
struct CheckpointManifest {
  int format = 2;  ///< 1 had other checksums
  int level = 0;  ///< the last finished one
  std::string program, reference, template_shape;
  struct File {
    std::string name, checksum;
  };
  std::vector<File> files;  ///< all others
};

std::string manifest_json(const CheckpointManifest& manifest);
/// Nothing where the file is missing or damaged. It may be of another format.
std::optional<CheckpointManifest> read_manifest(const std::string& path);

/// "cascade.nu: 0.0002, now 0.001" of the first option that differs between both and on which a run's levels depend;
/// empty if there is none. Number of threads, place of the shapes' files and `resume` change no level.
std::string changed_option(const ExperimentOptions& before, const ExperimentOptions& now);

}  // namespace shellmatch
