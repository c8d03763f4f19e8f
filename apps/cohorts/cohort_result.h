#pragma once
/// \file
/// The result of a cohort, as values: what is written to tables and meshes, and shown on its page.

#include "geometry/surface/surface.h"
#include "matching/result/match_summary.h"
#include "geometry/statistics/group_difference.h"
#include "geometry/statistics/model_curves.h"
#include "geometry/statistics/procrustes.h"
#include "geometry/statistics/shape_model.h"

#include <optional>
#include <string>
#include <vector>

namespace shellmatch {

/// One subject of a cohort: what became of it.
struct SubjectResult {
  std::string id, group;  ///< the group may be empty
  std::string status;     ///< "finished", "failed", "crashed", "timed_out", "out_of_memory", "diverged" or "not_run"
  std::string message;    ///< why it did not finish; may be empty
  std::string outcome;    ///< of the verdict: "matched", "look-here" or "not-matched"; empty where it did not finish
  std::vector<VerdictReason> reasons;
  std::optional<TwoSidedDistance> distance;  ///< over the diagonal of the subject's box
  double diagonal = 0;                       ///< of the subject's bounding box, in its unit
  double seconds = 0;
  std::string folder;     ///< of its result, relative to the cohort's: "runs/ID/output"; empty where there is none
  bool has_page = false;  ///< the result has a page of its own
  bool bent = false;      ///< the atlas' surface was bent before: the map is one of the surface
  bool in_model = false;  ///< whether it is a column of the statistics
};

/// Whether its matching ended at its limit of memory.
inline bool lacks_memory(const SubjectResult& subject) { return subject.status == "out_of_memory"; }

/// A round of the search for an unbiased atlas.
struct AtlasRound {
  int round = 0;
  std::size_t n_subjects = 0;  ///< that finished
  double change = 0;  ///< distance of the mean's surface from the round's atlas, root mean square over the diagonal
  double spread = 0;  ///< of the subjects about the mean, root mean square over the diagonal
};

template <int Dim>
struct CohortResult {
  std::string title, unit;              ///< the unit of the coordinates may be empty
  OriginalShape<Dim> atlas;             ///< the shape that was deformed onto every subject, as it was read
  Surface<Dim> surface;                 ///< its polygons as facets, of `atlas.vertices` in their order
  std::vector<SubjectResult> subjects;  ///< in the order of the cohort's table
  std::vector<std::size_t> rows;        ///< of `subjects`, for each column of the statistics
  PointSets aligned;                    ///< the atlas' vertices on every subject, after Procrustes analysis
  ProcrustesKind procrustes = ProcrustesKind::rigid;
  std::optional<ShapeModel> model;    ///< none for fewer than two subjects
  std::optional<ModelCurves> curves;  ///< none for fewer than three
  std::string group_a, group_b;       ///< of `difference`
  std::optional<GroupDifference> difference;
  std::vector<AtlasRound> rounds;  ///< may be empty
};

}  // namespace shellmatch
