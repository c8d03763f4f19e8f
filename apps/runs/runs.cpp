#include "apps/runs/runs.h"

#include "apps/process/limits.h"
#include "apps/terminal/time_left.h"
#include "apps/terminal/words.h"
#include "base/error.h"
#include "base/replace_file.h"
#include "base/stop.h"
#include "matching/output/checksum.h"
#include "matching/progress/process_info.h"

#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace shellmatch {

namespace {

constexpr std::string_view mark = "# Copy made by shellmatch; checksum of the lines above: ";

std::string marked(std::string text) {
  if (!text.ends_with('\n')) text += '\n';
  return text + std::string(mark) + text_checksum(text) + "\n";
}

bool is_marked(const std::string& contents) {
  const std::size_t at = contents.rfind(mark);
  return at != std::string::npos && contents == marked(contents.substr(0, at));
}

}  // namespace

std::string contents_of(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

void check_copy_place(const std::string& path, const std::string& text) {
  std::error_code error;
  if (!std::filesystem::exists(std::filesystem::symlink_status(path, error))) return;
  const std::string contents = contents_of(path);
  if (contents != text && !is_marked(contents))
    throw_input_error(
        "{}: is not replaced, since it has been written or edited by somebody; move it, or choose another folder with "
        "-o",
        path);
}

void keep_copy(const std::string& path, const std::string& text) {
  check_copy_place(path, text);
  if (const std::string contents = contents_of(path); contents != text && contents != marked(text))
    replace_file(path, marked(text));
}

void RunsProgress::run_started(const RunTask& run) { say(fmt::format("{} ...", run.name)); }

void RunsProgress::runs_begin(std::size_t n_runs) {
  n_runs_ = n_runs;
  n_ended_ = 0;
  begin_ = std::chrono::steady_clock::now();
}

void RunsProgress::run_ended(const RunTask& run, const RunResult& result) {
  ++n_ended_;
  say(fmt::format("{}: {} after {:.1f} s{}{}{}", run.name, status_name(result.status), result.seconds,
                  result.message.empty() ? "" : ": ", result.message, place()));
}

std::string RunsProgress::place() const {
  if (n_runs_ < 2) return "";
  std::string text = fmt::format(" ({} of {}", n_ended_, n_runs_);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  if (n_ended_ < n_runs_)
    text += ", " + time_left_text(seconds / static_cast<double>(n_ended_) * static_cast<double>(n_runs_ - n_ended_));
  return text + ")";
}

bool RunsProgress::stop_requested() { return stop_cause() != StopCause::none; }

void RunsProgress::say(const std::string& text) const {
  if (!is_quiet_) say_line("shellmatch: " + text);
}

int number_of_jobs(const std::string& text, int fallback) {
  if (text.empty()) return fallback;
  return whole_number(text, "--jobs", 1, 1024);
}

std::string checked_program(const std::string& program) {
  if (program.empty()) return "";
  const std::string path = std::filesystem::absolute(program).string();
  if (std::filesystem::is_directory(path) || access(path.c_str(), X_OK) != 0)
    throw_input_error("--program {}: is no program that can be executed", program);
  return path;
}

void keep_memory_of_runs(RunLimits& limits, int jobs) {
  const double share = static_cast<double>(memory_limit_bytes()) / 1e6 / jobs;
  if (share > 0 && (limits.memory_mb == 0 || limits.memory_mb > share)) limits.memory_mb = share;
}

}  // namespace shellmatch
