#include "apps/cohorts/report/worst_first.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace shellmatch {

namespace {

int gravity(const SubjectResult& subject) {
  if (subject.status != "finished") return 3;
  return subject.outcome == "not-matched" ? 2 : subject.outcome == "look-here" ? 1 : 0;
}

double greatest_distance(const SubjectResult& subject) {
  constexpr double unknown = std::numeric_limits<double>::infinity();
  if (!subject.distance) return unknown;
  const double there = subject.distance->deformed_to_template.max, back = subject.distance->template_to_deformed.max;
  return std::isnan(there) || std::isnan(back) ? unknown : std::max(there, back);
}

}  // namespace

std::vector<std::size_t> worst_first(const std::vector<SubjectResult>& subjects) {
  std::vector<std::size_t> order(subjects.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto key = [&](std::size_t i) { return std::pair(gravity(subjects[i]), greatest_distance(subjects[i])); };
  std::ranges::stable_sort(order, std::greater<>(), key);
  return order;
}

}  // namespace shellmatch
