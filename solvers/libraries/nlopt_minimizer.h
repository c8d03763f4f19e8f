#pragma once
/// \file
/// NLopt's gradient-based local methods behind our interface.

#include "solvers/libraries/library_options.h"
#include "solvers/minimizer.h"

namespace shellmatch {

enum class NloptMethod { lbfgs, tnewton, var1, var2, mma, ccsaq, slsqp };
template <>
struct EnumNames<NloptMethod> {
  static constexpr std::pair<NloptMethod, std::string_view> names[] = {
      {NloptMethod::lbfgs, "nlopt_lbfgs"}, {NloptMethod::tnewton, "nlopt_tnewton"},
      {NloptMethod::var1, "nlopt_var1"},   {NloptMethod::var2, "nlopt_var2"},
      {NloptMethod::mma, "nlopt_mma"},     {NloptMethod::ccsaq, "nlopt_ccsaq"},
      {NloptMethod::slsqp, "nlopt_slsqp"}};
};

/// LD_LBFGS, LD_TNEWTON_PRECOND_RESTART, LD_VAR1, LD_VAR2, LD_MMA, LD_CCSAQ and LD_SLSQP.
///
/// NLopt does not tell where one of its iterations ends: here a step is accepted whenever a point with a
/// lower value than all before has been evaluated. Counts of iterations, and `decrease_window`, are therefore
/// a little finer than with other methods; evaluations and seconds compare exactly.
///
/// NLopt has no word for "cannot be evaluated here". It is shown, in place of the function, the cone
/// f_b + |g_b| |x - x_b| over the best point x_b so far: it passes through that point, is never below it,
/// leads back to it, and has the size of what the library has seen there, so that its interpolation shortens
/// the step to between a quarter and a half. (A huge constant would make it collapse; infinities it
/// multiplies.) The cone is only ever shown where the function cannot be evaluated, and no point of it is
/// ever accepted.
///
/// When NLopt ends by its own rules (its methods often do, on account of rounding or of the cone's edge), it
/// is started again from the best point as long as that gains something, at most `max_restarts` times; the
/// message says how often and why it ended. NLopt's own tolerances are off. Exceptions pass through.
class NloptMinimizer final : public Minimizer {
 public:
  explicit NloptMinimizer(NloptMethod method, const NloptOptions& options = {})
      : method_(method), options_(options) {}
  std::string name() const override { return std::string(enum_name(method_)); }

  /// \throws InputError for nlopt_slsqp with more than max_slsqp_size unknowns.
  MinimizerSummary minimize(Objective& objective, std::vector<double>& x, const StopOptions& stop,
                            const IterationCallback& callback = {}) const override;

 private:
  NloptMethod method_;
  NloptOptions options_;
};

}  // namespace shellmatch
