#include "matching/self_test/self_test.h"

#include "matching/self_test/known_cases.h"

#include <fmt/format.h>

namespace shellmatch {

std::vector<SelfCheck> run_self_test(const std::function<void(const std::string& group)>& next) {
  std::vector<SelfCheck> all;
  const auto add = [&](const std::string& group, auto&& checks_of_group) {
    if (next) next(group);
    for (SelfCheck& check : checks_of_group()) {
      check.group = group;
      all.push_back(std::move(check));
    }
  };
  add("closed forms", [] { return check_closed_forms(); });
  add("gradients, 2D", [] { return check_gradients<2>(); });
  add("gradients, 3D", [] { return check_gradients<3>(); });
  add("folds, 2D", [] { return check_fold_certificates<2>(); });
  add("folds, 3D", [] { return check_fold_certificates<3>(); });
  add("match, 2D", [] { return check_match<2>(self_test_motion<2>(), self_test_motion<2>()); });
  add("match, 3D", [] { return check_match<3>(self_test_motion<3>(), self_test_motion<3>()); });
  return all;
}

std::string failed_checks(const std::vector<SelfCheck>& checks) {
  std::string names;
  for (const SelfCheck& check : checks)
    if (!check.passed()) names += fmt::format("{}{}: {}", names.empty() ? "" : ", ", check.group, check.name);
  return names;
}

std::string self_test_text(const std::vector<SelfCheck>& checks) {
  std::string text = fmt::format("{:<16}{:<52}{:>10}{:>10}\n", "", "", "figure", "bound");
  for (const SelfCheck& check : checks)
    text += fmt::format("{:<16}{:<52}{:>10.2e}{:>10.2e}  {}\n", check.group, check.name, check.figure, check.bound,
                        check.passed() ? "ok" : "FAILED");
  return text;
}

}  // namespace shellmatch
