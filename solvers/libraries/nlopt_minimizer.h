#pragma once
/// \file
/// Adapter of NLopt's gradient-based local methods.

#include "base/options.h"
#include "solvers/minimizer.h"

namespace shellmatch {

enum class NloptMethod { lbfgs, var1, var2, mma, ccsaq };
template <>
struct EnumNames<NloptMethod> {
  static constexpr std::pair<NloptMethod, std::string_view> names[] = {{NloptMethod::lbfgs, "nlopt_lbfgs"},
                                                                       {NloptMethod::var1, "nlopt_var1"},
                                                                       {NloptMethod::var2, "nlopt_var2"},
                                                                       {NloptMethod::mma, "nlopt_mma"},
                                                                       {NloptMethod::ccsaq, "nlopt_ccsaq"}};
};

/// LD_LBFGS, LD_VAR1, LD_VAR2, LD_MMA and LD_CCSAQ.
///
/// NLopt does not report the end of an iteration. Here a step is accepted whenever a point with a lower value
/// than all previous ones has been evaluated. Numbers of iterations, and `decrease_window`, are therefore
/// slightly finer than with other methods; numbers of evaluations and seconds are comparable.
///
/// NLopt cannot represent points at which the function cannot be evaluated. At these points it is given the
/// cone f_b + |g_b| |x - x_b| over the best point x_b so far. The cone agrees with the function at x_b,
/// exceeds f_b elsewhere and has a slope of comparable size, so the library's interpolation shortens the step
/// to between a quarter and a half. (A huge constant would shorten it to almost nothing; infinities lead to
/// NaN.) No point on the cone is ever accepted.
///
/// When NLopt stops by its own rules (often because of rounding, or of the kink between function and cone),
/// it is restarted from the best point as long as that lowers the value, at most `max_restarts` times; the
/// message states the number of restarts and the reason. NLopt's own tolerances are disabled. Exceptions are
/// passed to the caller.
class NloptMinimizer final : public Minimizer {
 public:
  /// \param max_stalled evaluations without a lower value after which it is restarted
  explicit NloptMinimizer(NloptMethod method, int max_stalled = 200, int max_restarts = 20)
      : method_(method), max_stalled_(max_stalled), max_restarts_(max_restarts) {}
  std::string name() const override { return std::string(enum_name(method_)); }

  MinimizerSummary minimize(Objective& objective, std::vector<double>& x, const StopOptions& stop,
                            const IterationCallback& callback = {}) const override;

 private:
  NloptMethod method_;
  int max_stalled_, max_restarts_;
};

}  // namespace shellmatch
