#pragma once
/// \file
/// Writes the output folder of a matching from its result.

#include "matching/experiment/options.h"
#include "matching/output/output_folder.h"
#include "matching/progress/observer.h"
#include "matching/result/match_result.h"

#include <functional>
#include <string>

namespace shellmatch {

/// Writes deformed.ply and template.ply (.csv in the plane), deformation.vtu, history.csv, config.yaml, summary.json
/// and, if `options.report` and `options.pictures` request them, report.html and the pictures of the result; all files
/// or none, but for a report and pictures that cannot be made (draw()). \param options those of the matching \param
/// folder the output folder; missing parents are created \param force whether to replace the folder of an earlier run
/// \param observer is warned of what is missing; none: nobody is
/// \throws InputError, EnvironmentError as OutputFolder (matching/output/output_folder.h)
template <int Dim>
void write_result_folder(const MatchResult<Dim>& result, const ExperimentOptions& options, const std::string& folder,
                         bool force = false, Observer* observer = nullptr);

/// Writes the same files without summary.json into a folder that the caller commits. The caller writes summary.json
/// last, because it states the time spent on writing. A file of outlines has the points of one ring after another and
/// no others: where a program has given them otherwise, the lines are in that order, which the numbers in template_v0
/// and template_v1 follow.
template <int Dim>
void write_result_files(const MatchResult<Dim>& result, const ExperimentOptions& options, OutputFolder& folder,
                        Observer& observer);

/// Writes report.html if `options.report` asks for it, with the picture of the result that is in the folder. The caller
/// calls it before it writes summary.json, with the times so far in the summary. A report that cannot be made does not
/// end a run (draw()).
template <int Dim>
void write_result_page(const MatchResult<Dim>& result, const ExperimentOptions& options, OutputFolder& folder,
                       Observer& observer);

/// Draws one picture, NAME in the folder. A picture that cannot be drawn or written does not end a run: it is removed,
/// and the observer is told. \throws Stopped
void draw(OutputFolder& folder, const std::string& name, Observer& observer,
          const std::function<void(const std::string& path)>& write);

}  // namespace shellmatch
