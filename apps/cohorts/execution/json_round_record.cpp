#include "base/replace_file.h"
#include "apps/cohorts/execution/round_record.h"
#include "matching/json/json_members.h"

namespace shellmatch {

SHELLMATCH_JSON(RoundRecord, cohort, results, (round.round, round), (round.n_subjects, n_subjects),
                (round.change, change), (round.spread, spread), converged, nearest)

void write_round(const RoundRecord& record, const std::string& path) { replace_file(path, json_text(json_of(record))); }

std::optional<RoundRecord> read_round(const std::string& path) { return read_json<RoundRecord>(path); }

}  // namespace shellmatch
