#pragma once
/// \file
/// Checkpoints: after the alignment and at the end of levels (resume.min_seconds) a run writes its state to the folder
/// NAME.unfinished beside its output folder NAME, in the place of the checkpoint before, so that the same command
/// resumes a run that was stopped or killed.

#include "geometry/surface/surface.h"
#include "matching/alignment/alignment_findings.h"
#include "matching/level/deformation.h"
#include "matching/output/history_file.h"
#include "matching/output/output_folder.h"
#include "matching/experiment/options.h"
#include "matching/pairs/landmarks.h"
#include "matching/output/summary.h"
#include "matching/result/match_result.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace shellmatch {

/// All data on which the levels of a run depend. A checkpoint is resumed only by a run of equal identity.
struct RunIdentity {
  ExperimentOptions options;
  /// Checksums of both shapes as they were read, before they are placed together: contents are compared, not file
  /// names.
  std::string reference, template_shape;
  std::string landmarks;  ///< checksum of what the landmarks say; empty without any
  std::string program;    ///< version, compiler and checksum of the code's file: builds may differ in rounding, and so
                          ///< may vector units
};

template <int Dim>
RunIdentity run_identity(const ExperimentOptions& options, const OriginalShape<Dim>& reference,
                         const OriginalShape<Dim>& template_shape, const std::vector<Landmark<Dim>>& landmarks);

/// A checkpoint as it is written, by references to the state of the running cascade.
template <int Dim>
struct CheckpointView {
  const Octree<Dim>& grid;
  const std::vector<Vec<Dim>>& phi;
  const MapFrame<Dim>& frame;
  const History& history;
  const MatchSummary& summary;
  const std::vector<LevelVertices<Dim>>& levels;  ///< as MatchProgress::levels
  const AlignmentFindings<Dim>& findings;
};

/// The folder of a run's checkpoint. After a level it has the files of an output folder except the deformed shape, so
/// that the command `apply` accepts it; before, it has what the alignment has found alone. It is replaced atomically: a
/// kill at any moment leaves the old checkpoint or the new one.
class CheckpointFolder {
 public:
  /// Removes the remains of a checkpoint that a killed run was writing. \param output absolute path of the output
  /// folder
  CheckpointFolder(const std::string& output, RunIdentity identity);

  const std::string& path() const { return path_; }

  /// Whether the name is taken by something that is no checkpoint. Then no checkpoint can be written.
  bool is_foreign() const;

  /// The reason why the run cannot resume from the checkpoint, such as "the template is another one" or "its
  /// history.csv is damaged"; empty where it can, or where there is no checkpoint. \pre not is_foreign()
  std::string obstacle() const;

  /// The level after which the checkpoint was written; 0 before the first, or where there is none that can be read.
  int level() const;

  /// What the alignment of the earlier run had found; nothing without a checkpoint. \pre obstacle() is empty
  /// \throws InputError for an intact file with invalid contents
  template <int Dim>
  AlignmentFindings<Dim> read_alignment() const;

  /// What the earlier run had reached, if there is a checkpoint after a level. \param n_vertices of the reference's
  /// surface \pre obstacle() is empty \throws InputError for intact files with invalid contents
  template <int Dim>
  std::optional<MatchProgress<Dim>> read(std::size_t n_vertices) const;

  /// What is in the folder besides a checkpoint, as "'thesis' in it is of no run"; empty where there is nothing. As
  /// long as it is there, no checkpoint can be written.
  std::string foreign_text() const;

  /// Replaces the checkpoint. \param pictures folder of the run's pictures so far
  /// \throws EnvironmentError if it cannot be written, InputError if foreign_text() is not empty; the earlier
  /// checkpoint then stays. \pre not is_foreign()
  template <int Dim>
  void write(const CheckpointView<Dim>& checkpoint, const std::string& pictures);

  /// The same before the first level.
  template <int Dim>
  void write(const AlignmentFindings<Dim>& findings);

  /// Copies the pictures of the finished levels into the folder `pictures` of a resumed run. \throws EnvironmentError
  void copy_pictures(const std::string& pictures) const;

  /// Removes the files of the checkpoint, after the run has written its output, and the folder unless anything else is
  /// in it.
  void remove();

 private:
  bool is_ours() const;
  void write_rest(OutputFolder& folder, int level) const;

  std::string path_;
  RunIdentity identity_;
};

/// Contents of state.json, the file by which a checkpoint is recognised. Its files stand in files.json, as those of
/// every output folder.
struct CheckpointManifest {
  int format = 5;  ///< of the checkpoint; format 4 had no alignment.cbor, format 3 no levels.bin, format 2 listed the
                   ///< files itself, format 1 had other checksums
  int level = 0;   ///< the finished level that was kept; 0: none yet
  std::string program, reference, template_shape;
  std::optional<std::string> landmarks;
};

std::string manifest_json(const CheckpointManifest& manifest);
/// The manifest in the file, which may be of another format; nothing where the file is missing or damaged.
std::optional<CheckpointManifest> read_manifest(const std::string& path);

/// The first difference between the options that change a run's levels, as "cascade.nu: 0.0002, now 0.001"; empty if
/// there is none. The number of threads, paths of shapes and the section `resume` change no level.
std::string changed_option(const ExperimentOptions& before, const ExperimentOptions& now);

}  // namespace shellmatch
