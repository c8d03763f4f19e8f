#include "apps/cohorts/output/cohort_summary.h"
#include "matching/json/json_members.h"

namespace shellmatch {

template <class Value, class Member>
requires std::is_same_v<std::remove_const_t<Value>, Spread>
static void describe(Value& s, Member&& member) {
  member("n", s.n);
  member("median", s.median);
  member("p95", s.p95);
  member("max", s.max);
}

template <class Value, class Member>
requires std::is_same_v<std::remove_const_t<Value>, AtlasRound>
static void describe(Value& r, Member&& member) {
  member("round", r.round);
  member("n_subjects", r.n_subjects);
  member("change", r.change);
  member("spread", r.spread);
}

template <class Value, class Member>
requires std::is_same_v<std::remove_const_t<Value>, CohortSummary>
static void describe(Value& s, Member&& member) {
  member("version", s.version);
  member("title", s.title);
  member("unit", s.unit);
  member("n_subjects", s.n_subjects);
  member("n_finished", s.n_finished);
  member("n_matched", s.n_matched);
  member("n_look_here", s.n_look_here);
  member("n_not_matched", s.n_not_matched);
  member("n_in_model", s.n_in_model);
  member("rounds", s.rounds);
  member("deformed_to_subject", s.deformed_to_subject);
  member("subject_to_deformed", s.subject_to_deformed);
  member("landmarks", s.landmarks);
  member("standard_deviation", s.standard_deviation);
  member("compactness", s.compactness);
  member("group_a", s.group_a);
  member("group_b", s.group_b);
  member("group_distance", s.group_distance);
  member("group_p", s.group_p);
  member("differing_share", s.differing_share);
}

std::string cohort_summary_json(const CohortSummary& summary) { return json_text(json_of(summary)); }

}  // namespace shellmatch
