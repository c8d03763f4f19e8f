#include "apps/cohorts/output/cohort_summary.h"
#include "matching/json/json_members.h"

namespace shellmatch {

SHELLMATCH_JSON(Spread, n, median, p95, max)
SHELLMATCH_JSON(AtlasRound, round, n_subjects, change, spread)
SHELLMATCH_JSON(CohortSummary, version, title, unit, n_subjects, n_finished, n_matched, n_look_here, n_not_matched,
                n_in_model, rounds, deformed_to_subject, subject_to_deformed, landmarks, standard_deviation,
                compactness, group_a, group_b, group_distance, group_p, differing_share)

std::string cohort_summary_json(const CohortSummary& summary) { return json_text(json_of(summary)); }

}  // namespace shellmatch
