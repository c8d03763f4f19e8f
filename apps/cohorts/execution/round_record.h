#pragma once
/// \file
/// The end of a round: the file round.json in its folder, which says that its mean is there.

#include "apps/cohorts/cohort_result.h"

#include <optional>
#include <string>

namespace shellmatch {

struct RoundRecord {
  std::string cohort;   ///< checksum of all of the cohort's description on which means depend
  std::string results;  ///< checksum of all on which the mean depends
  AtlasRound round;
  bool converged = false;  ///< the mean has moved by no more than atlas.tolerance allows
  std::string nearest;     ///< id of the subject nearest to the mean
};

/// \throws EnvironmentError if the file cannot be written
void write_round(const RoundRecord& record, const std::string& path);

/// Nothing where the file is missing or damaged.
std::optional<RoundRecord> read_round(const std::string& path);

}  // namespace shellmatch
