// `self-test`: checks what this program computes on this machine against what is known.

#include "apps/commands.h"
#include "apps/process/interrupt.h"
#include "base/error.h"
#include "base/parallel.h"
#include "matching/self_test/self_test.h"

#include <algorithm>
#include <charconv>
#include <iostream>

namespace shellmatch {

void execute(const SelfTestCommand& command) {
  catch_interrupts();
  int threads = 0;
  const auto [end, error] = std::from_chars(command.threads.data(), command.threads.data() + command.threads.size(), threads);
  if (!command.threads.empty() && (error != std::errc() || end != command.threads.data() + command.threads.size() || threads < 0))
    throw_input_error("--threads {}: expected the number of threads, 0 for all of the machine", command.threads);
  set_n_threads(threads);
  const auto checks = run_self_test([&](const std::string& group) {
    if (command.verbosity == Verbosity::verbose) std::cerr << fmt::format("{} ...\n", group);
  });
  if (command.verbosity != Verbosity::quiet) std::cout << self_test_text(checks);
  const auto n_failed = std::ranges::count_if(checks, [](const SelfCheck& c) { return !c.passed(); });
  if (n_failed > 0) throw CheckFailed(fmt::format("self-test: {} of {} checks failed: {}", n_failed, checks.size(), failed_checks(checks)));
}

}  // namespace shellmatch
