#pragma once
/// \file
/// The description of a result for the page: all but the packed arrays.

#include "matching/experiment/options.h"
#include "matching/report/packed_arrays.h"
#include "matching/report/page.h"
#include "matching/result/match_summary.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace shellmatch {

/// What the page needs to know besides summary, options and arrays.
struct ReportFrame {
  int grid_level = 0;  ///< finest level of the outline of the grid
  bool is_backward = false;
  double domain_side = 1;  ///< side of the unit domain in the template's unit
  /// A point of the unit domain in the coordinates of the template: the images of the origin and of the unit vectors.
  std::vector<std::array<double, 3>> domain;
  std::optional<PageView> view;         ///< of shapes in space, in those coordinates
  std::vector<int> levels;              ///< of which the deformed vertices are there
  std::vector<std::string> term_names;  ///< of the history
  std::string picture;                  ///< base64 of a PNG; may be empty
};

/// As JSON that may stand within an element of a page: it has no '<'.
std::string report_json(const MatchSummary& summary, const ExperimentOptions& options, const ReportFrame& frame,
                        const std::vector<PackedArray>& arrays);

}  // namespace shellmatch
