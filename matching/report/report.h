#pragma once
/// \file
/// report.html: one page that shows a result, and opens without a network (docs/report.md). Its program and style stand
/// in matching/page/.

#include "matching/experiment/options.h"
#include "matching/result/match_result.h"

#include <string>
#include <string_view>

namespace shellmatch {

inline constexpr const char* report_file_name = "report.html";

/// The page. It holds, besides the program, the three surfaces that were matched in the coordinates of the template,
/// with the deformed one at the end of each level in `result.levels`, colours, the grid, the history, the summary and
/// the options. \param picture bytes of a PNG shown where the browser cannot draw surfaces; may be empty
template <int Dim>
std::string report_html(const MatchResult<Dim>& result, const ExperimentOptions& options,
                        std::string_view picture = {});

/// \throws EnvironmentError if the file cannot be written
template <int Dim>
void write_report(const MatchResult<Dim>& result, const ExperimentOptions& options, std::string_view picture,
                  const std::string& path);

}  // namespace shellmatch
