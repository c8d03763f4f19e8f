#pragma once
/// \file
/// summary.json: the figures of a matching as a file.

#include "matching/result/match_summary.h"

#include <string>

namespace shellmatch {

/// Everything but `run` is the same to the bit between runs of the same experiment, whatever the number of
/// threads. Doubles are written in the shortest form that reads back to the same bits, those that are not
/// finite as null, and what is not known is left out.
std::string summary_json(const MatchSummary& summary);

/// \throws EnvironmentError if the file cannot be written
void write_summary(const MatchSummary& summary, const std::string& path);

/// Reads a summary back; null becomes NaN. \throws InputError that says what is wrong with the file
MatchSummary read_summary(const std::string& path);

}  // namespace shellmatch
