#pragma once
/// \file
/// The output folder of a matching, made of its result.

#include "matching/experiment/options.h"
#include "matching/output/output_folder.h"
#include "matching/result/match_result.h"

#include <string>

namespace shellmatch {

/// Writes deformed.ply (deformed.csv in the plane), deformation.vtu, history.csv, config.yaml, summary.json and, as
/// `options.pictures` asks for them, the pictures of the end, all of it or nothing.
/// \param options those of the matching
/// \param folder its parents are created where they are missing
/// \param force replaces a folder that an earlier run has written
/// \throws InputError, EnvironmentError as OutputFolder (matching/output/output_folder.h)
template <int Dim>
void write_result(const MatchResult<Dim>& result, const ExperimentOptions& options, const std::string& folder,
                  bool force = false);

/// The same without summary.json, which comes last where it is to tell the time that writing takes, into a folder that
/// the caller commits.
template <int Dim>
void write_result_files(const MatchResult<Dim>& result, const ExperimentOptions& options, OutputFolder& folder);

}  // namespace shellmatch
