// `self-test`: checks what this program computes on this machine against what is known.

#include "apps/commands.h"
#include "apps/process/interrupt.h"
#include "apps/terminal/words.h"
#include "base/error.h"
#include "base/parallel.h"
#include "matching/self_test/self_test.h"

#include <algorithm>
#include <iostream>

namespace shellmatch {

void execute(const SelfTestCommand& command) {
  catch_interrupts();
  set_n_threads(command.threads.empty() ? 0 : whole_number(command.threads, "--threads", 0));
  const auto checks = run_self_test([&](const std::string& group) {
    if (command.verbosity == Verbosity::verbose) std::cerr << fmt::format("{} ...\n", group);
  });
  if (command.verbosity != Verbosity::quiet) std::cout << self_test_text(checks);
  const auto n_failed = std::ranges::count_if(checks, [](const SelfCheck& c) { return !c.passed(); });
  if (n_failed > 0)
    throw CheckFailed(
        fmt::format("self-test: {} of {} checks failed: {}", n_failed, checks.size(), failed_checks(checks)));
}

}  // namespace shellmatch
