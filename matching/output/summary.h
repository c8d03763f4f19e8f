#pragma once
/// \file
/// summary.json: the figures of a matching.

#include "matching/result/match_summary.h"

#include <string>

namespace shellmatch {

/// The summary as JSON. All but `run` is the same bit for bit in repeated runs of an experiment, whatever the number of
/// threads. Doubles are written in the shortest form that reads back exactly, those that are not finite as null;
/// unknown values are omitted.
std::string summary_json(const MatchSummary& summary);

/// \throws EnvironmentError if the file cannot be written
void write_summary(const MatchSummary& summary, const std::string& path);

/// Reads a summary; null becomes NaN. \throws InputError that says what is wrong with the file
MatchSummary read_summary(const std::string& path);

}  // namespace shellmatch
