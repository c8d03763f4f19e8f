#include "matching/render/canvas/ticks.h"

#include "base/error.h"

#include <algorithm>
#include <cmath>

namespace shellmatch {

std::string short_number(double x) { return fmt::format("{:.4g}", x == 0 ? 0.0 : x); }

std::vector<Tick> linear_ticks(double min, double max, int wanted) {
  SHELLMATCH_CHECK(std::isfinite(min) && std::isfinite(max) && min < max, "an axis needs an extent");
  const double raw = (max - min) / std::max(1, wanted);
  const double power = std::pow(10, std::floor(std::log10(raw)));
  const double share = raw / power;
  const double step = power * (share < 1.5 ? 1 : share < 3.5 ? 2 : share < 7.5 ? 5 : 10);
  std::vector<Tick> ticks;
  const double tolerance = 1e-9 * step;
  for (double k = std::ceil((min - tolerance) / step); k * step <= max + tolerance; ++k)
    ticks.push_back({k * step, short_number(std::abs(k * step) < tolerance ? 0 : k * step)});
  return ticks;
}

std::vector<Tick> log_ticks(double min, double max, int wanted) {
  SHELLMATCH_CHECK(min > 0 && std::isfinite(max) && min < max, "a logarithmic axis needs a positive extent");
  const double slack = 1e-9;
  const int first = static_cast<int>(std::floor(std::log10(min) - slack));
  const int last = static_cast<int>(std::ceil(std::log10(max) + slack));
  const auto inside = [&](double x) { return x >= min * (1 - slack) && x <= max * (1 + slack); };
  int n_powers = 0;
  for (int e = first; e <= last; ++e) n_powers += inside(std::pow(10.0, e));
  const int stride = std::max(1, (n_powers + wanted - 1) / std::max(1, wanted));
  std::vector<Tick> ticks;
  for (int e = first; e <= last; ++e)
    for (int digit = 1; digit <= 9; ++digit) {
      const double x = digit * std::pow(10.0, e);
      if (!inside(x)) continue;
      const bool power = digit == 1, few = n_powers < 2 && (digit == 2 || digit == 5);
      if (power && e % stride == 0) ticks.push_back({x, short_number(x)});
      else if (few) ticks.push_back({x, short_number(x)});
      else if (stride == 1 || power) ticks.push_back({x, ""});
    }
  return ticks;
}

}  // namespace shellmatch
