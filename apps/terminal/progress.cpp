#include "apps/terminal/progress.h"

#include "apps/terminal/words.h"
#include "base/printable.h"
#include "base/stop.h"
#include "matching/derivative_check/gradient_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdio>

namespace shellmatch {

namespace {

std::string place(const LevelStart& start, int max_level) {
  std::string text = fmt::format("level {}/{}", start.level, max_level);
  if (start.n_substeps > 1) text += fmt::format(", step {}/{}", start.substep, start.n_substeps);
  return text;
}

// The rest of an activity of which a tenth is done, with a comma before it, or nothing.
std::string left_of(const std::optional<ActivityState>& activity) {
  if (!activity || activity->share < 0.1) return "";
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - activity->begin;
  return ", " + time_left_text(elapsed.count() * (1 / activity->share - 1));
}

std::size_t terminal_width() {
  winsize size{};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 20 ? size.ws_col : 80;
}

}  // namespace

Progress::Progress(Verbosity verbosity, int max_level)
    : verbosity_(verbosity),
      max_level_(max_level),
      terminal_(verbosity == Verbosity::normal && isatty(STDERR_FILENO) != 0),
      time_left_(max_level) {
  if (terminal_) heartbeat_.emplace([this] { beat(); });
}

Progress::~Progress() { finished(); }

void Progress::finished() {
  heartbeat_.reset();
  const std::lock_guard lock(mutex_);
  clear();
}

double Progress::now() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
}

void Progress::clear() {
  if (pending_) std::fputs("\r\x1b[K", stderr);
  pending_ = false;
}

void Progress::say(const std::string& text) {
  clear();
  say_line(text);
}

void Progress::line(const std::string& text) {
  if (verbosity_ != Verbosity::quiet) say(text);
}

void Progress::rewrite(const std::string& text) {
  last_rewrite_ = now();
  pending_ = true;
  // The line is cut to the terminal's width, because a wrapped line cannot be rewritten.
  std::fputs(fmt::format("\r{}\x1b[K", text.substr(0, terminal_width() - 1)).c_str(), stderr);
  std::fflush(stderr);
}

std::string Progress::left() const {
  const std::optional<double> seconds = has_estimate_ ? time_left_.at(now()) : std::nullopt;
  return seconds ? ", " + time_left_text(*seconds) : "";
}

// What takes long without a word says how long, and what of it is done (base/stop.h).
void Progress::beat() {
  const std::lock_guard lock(mutex_);
  if (!doing_.empty() && now() - last_rewrite_ >= 0.9) show_activity();
}

void Progress::show_activity() {
  const std::optional<ActivityState> activity = last_activity();
  const std::string part = activity && activity->name != doing_ ? ", " + activity->name : "";
  const double here = now() - doing_since_;
  rewrite(fmt::format("{}{}: {:.0f} s{}{}", doing_, part, here,
                      now() - here >= 1 ? fmt::format(" of {:.0f} s so far", now()) : "",
                      has_estimate_ ? left() : left_of(activity)));
}

void Progress::warn(const std::string& text) {
  const std::lock_guard lock(mutex_);
  say(text);
}

void Progress::note(const std::string& text) {
  const std::lock_guard lock(mutex_);
  line(text);
}

void Progress::stage(const std::string& name) {
  stop_if_wanted();
  const std::lock_guard lock(mutex_);
  doing_ = name;
  doing_since_ = now();
  has_estimate_ = false;
  if (terminal_) rewrite(name);
  else if (now() > 0.05 || verbosity_ == Verbosity::verbose)
    line(fmt::format("{} ({:.1f} s)", name, now()));  // what begins at once needs no word
}

void Progress::trial_iterated() {
  stop_if_wanted();
  const std::lock_guard lock(mutex_);
  if (terminal_ && now() - last_rewrite_ > 0.1) show_activity();
}

void Progress::minimisation_started(const LevelStart& start) {
  stop_if_wanted();
  const std::lock_guard lock(mutex_);
  time_left_.started(start.level, start.substep, start.n_substeps, start.n_nodes, now());
  has_estimate_ = true;
  doing_ = place(start, max_level_);
  doing_since_ = now();
  std::string text =
      fmt::format("{}: {} nodes, {} of them free, {} cells", doing_, start.n_nodes, start.n_free_nodes, start.n_cells);
  if (verbosity_ == Verbosity::verbose)
    text += fmt::format(", nu {:.3g}, c_vol {:.3g}, sigma {:.3g}", start.nu, start.volume_weight, start.sigma);
  if (terminal_) rewrite(text);
  else if (start.substep == 1 || verbosity_ == Verbosity::verbose) line(text);
}

bool Progress::iterated(const LevelStart& start, const IterationRecord& record) {
  stop_if_wanted();
  const std::lock_guard lock(mutex_);
  if (verbosity_ == Verbosity::verbose) {
    line(fmt::format(
        "{}, iteration {}: energy {:.6e}, terms {:.4e}, gradient {:.3e}, step {:.3e}, {} evaluations, {:.2f} s",
        place(start, max_level_), record.iteration, record.value, fmt::join(record.terms, " "), record.gradient_norm,
        record.step, record.value_evaluations, record.seconds));
  } else if (terminal_ && now() - last_rewrite_ > 0.1) {
    rewrite(fmt::format("{}, iteration {}: energy {:.4e}, {:.0f} s so far{}", place(start, max_level_),
                        record.iteration, record.value, now(), left()));
  }
  return true;
}

void Progress::gradient_checked(const LevelStart& start, const GradientReport& report) {
  if (report.passed() && verbosity_ != Verbosity::verbose && terminal_) return;
  const std::lock_guard lock(mutex_);
  line(fmt::format("{}, iteration {}: derivatives {}", place(start, max_level_), report.iteration,
                   report.passed() ? "checked" : "WRONG: " + report.faults()));
}

void Progress::minimisation_finished(const LevelStart& start, const MinimizerSummary& summary) {
  if (verbosity_ != Verbosity::verbose && start.substep < start.n_substeps) return;
  const std::lock_guard lock(mutex_);
  line(fmt::format("{}: energy {:.4e} after {} iterations in {:.1f} s ({}){}", place(start, max_level_),
                   summary.final_value, summary.iterations, summary.seconds, enum_name(summary.reason),
                   start.level < max_level_ ? left() : ""));
  for (const LibraryReport& report : summary.library_reports)
    line(verbosity_ == Verbosity::verbose ? report.full : report.brief);
}

}  // namespace shellmatch
