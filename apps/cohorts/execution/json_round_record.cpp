#include "base/replace_file.h"
#include "apps/cohorts/execution/round_record.h"
#include "matching/json/json_members.h"

#include <fstream>

namespace shellmatch {

template <class Record, class Member>
requires std::is_same_v<std::remove_const_t<Record>, RoundRecord>
static void describe(Record& r, Member&& member) {
  member("cohort", r.cohort);
  member("results", r.results);
  member("round", r.round.round);
  member("n_subjects", r.round.n_subjects);
  member("change", r.round.change);
  member("spread", r.round.spread);
  member("converged", r.converged);
  member("nearest", r.nearest);
}

void write_round(const RoundRecord& record, const std::string& path) { replace_file(path, json_text(json_of(record))); }

std::optional<RoundRecord> read_round(const std::string& path) {
  std::ifstream in(path);
  if (!in) return std::nullopt;
  try {
    RoundRecord record;
    set_from_json(parse_json(in), record);
    return record;
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

}  // namespace shellmatch
