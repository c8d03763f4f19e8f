#include "apps/studies/execution/run_tasks.h"

#include "base/error.h"
#include "base/printable.h"
#include "base/replace_file.h"
#include "matching/output/leftovers.h"
#include "matching/output/output_folder.h"
#include "matching/output/summary.h"
#include "matching/output/write_file.h"
#include "matching/progress/exit_code.h"
#include "matching/progress/process_info.h"
#include "apps/studies/execution/child_process.h"
#include "apps/studies/execution/machine.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <thread>
#include <utility>

namespace shellmatch {

namespace fs = std::filesystem;

namespace {

// The last line of a log without the program's name, as "error: not enough memory; ...".
std::string last_words(const std::string& log) {
  std::ifstream in(log, std::ios::binary | std::ios::ate);
  if (!in) return "log.txt cannot be read";
  const std::streamoff end = in.tellg(), from = std::max<std::streamoff>(0, end - 2000);
  in.seekg(from);
  std::string last;
  for (std::string line; std::getline(in, line);)
    if (!line.empty()) last = line;
  const std::string prefix = "shellmatch: ";
  return printable(last.starts_with(prefix) ? last.substr(prefix.size()) : last, max_message_length);
}

// Sets the status of a run whose process exited without an error, from its output.
void judge_output(const std::string& output, RunResult& result) {
  result.status = RunStatus::failed;
  try {
    const MatchSummary summary = read_summary(output + "/summary.json");
    result.program = summary.version;
    if (summary.levels.empty()) throw InputError("the summary holds no level");
    const LevelSummary& last = summary.levels.back();
    if (last.stop_reason == "cannot_evaluate_start" || last.energy_minimised.empty() ||
        !std::isfinite(last.energy_minimised.back().second)) {
      result.status = RunStatus::diverged;
      result.message = fmt::format("level {}: {} ({})", last.level, last.stop_reason, last.stop_message);
    } else {
      // A program of the user's (--program) may write what it has reached when it is stopped; ours does not.
      result.status = summary.interrupted ? RunStatus::failed : RunStatus::finished;
      if (summary.interrupted) result.message = "stopped before the last level was finished";
    }
  } catch (const InputError& error) {
    result.message = fmt::format("exit code 0, but without a result: {}", error.what());
  }
}

// A run in progress, whose folder takes the place of a result of another configuration at its end. Destroyed before its
// end, it kills the process and removes its folder.
class ActiveRun {
 public:
  ActiveRun(const RunTask& run, const std::string& place, const std::string& program, const ProcessLimits& limits,
            RunResult result)
      : run_(&run), folder_(place, true), result_(std::move(result)) {
    const std::string config = folder_.path_of("config.yaml");
    write_file(config, run.config);
    child_ = std::make_unique<ChildProcess>(
        std::vector<std::string>{program, "run", config, "-o", folder_.path_of("output")}, folder_.path_of("log.txt"),
        limits);
  }

  // Returns true once the process has ended and its folder has been committed.
  bool advance() {
    const std::optional<ProcessResult> end = child_->poll();
    if (!end) return false;
    result_.exit_code = end->exit_code;
    result_.signal = end->signal;
    result_.seconds = end->seconds;
    result_.peak_memory_bytes = end->peak_memory_bytes;
    judge(end->end);
    remove_hidden(folder_.path_of("output"));
    write_run_result(result_, folder_.path_of("result.json"));
    folder_.commit();
    return true;
  }

  const RunTask& run() const { return *run_; }
  const RunResult& result() const { return result_; }

 private:
  void judge(ProcessEnd end) {
    if (end == ProcessEnd::timed_out) {
      result_.status = RunStatus::timed_out;
      result_.message = fmt::format("ended after {:g} s", result_.limit_seconds);
    } else if (end == ProcessEnd::out_of_memory) {
      result_.status = RunStatus::out_of_memory;
      result_.message = fmt::format("ended at {:g} MB", result_.limit_memory_mb);
    } else if (end == ProcessEnd::signalled) {
      result_.status = RunStatus::crashed;
      result_.message = fmt::format("signal {} ({})", result_.signal, strsignal(result_.signal));
    } else if (result_.exit_code == 0) {
      judge_output(folder_.path_of("output"), result_);
    } else {
      result_.message = last_words(folder_.path_of("log.txt"));
      // That is no result of the run, and the next ones would end likewise.
      if (result_.exit_code == exit_code::disk_error)
        throw DiskError(
            fmt::format("{}: {}; all results so far are kept, and the same command goes on once there is room",
                        run_->name, result_.message));
      const bool lacks_memory = result_.exit_code == exit_code::memory_error;
      result_.status = lacks_memory ? RunStatus::out_of_memory : RunStatus::failed;
    }
  }

  const RunTask* run_;
  OutputFolder folder_;
  RunResult result_;
  std::unique_ptr<ChildProcess> child_;
};

// Whether the run has to be performed, given its earlier result.
bool is_due(const RunResult& result, const RunLimits& limits, bool retry) {
  const auto raised = [](double now, double then) { return then > 0 && (now == 0 || now > then); };
  switch (result.status) {
    case RunStatus::not_run: return true;
    case RunStatus::finished: return false;
    case RunStatus::timed_out: return retry || raised(limits.seconds, result.limit_seconds);
    case RunStatus::out_of_memory: return retry || raised(limits.memory_mb, result.limit_memory_mb);
    default: return retry;
  }
}

}  // namespace

bool run_tasks(const std::vector<const RunTask*>& runs, const RunLimits& limits, const RunsFolder& folder,
               const TaskSettings& settings, TaskObserver& observer) {
  // The executable of this process, even if its file has been replaced meanwhile: all runs of a study use one build.
  const std::string program = settings.program.empty() ? "/proc/self/exe" : settings.program;
  const std::string machine = machine_text();
  // A folder that must not be replaced is told before hours are spent on the runs before it.
  std::size_t n_due = 0;
  for (const RunTask* run : runs) {
    if (!is_due(folder.result_of(*run), limits, settings.retry)) continue;
    ++n_due;
    if (const std::string place = folder.run_folder(*run); fs::exists(place)) OutputFolder(place, true);
  }
  observer.runs_begin(n_due);
  std::vector<std::unique_ptr<ActiveRun>> active;
  for (std::size_t next = 0; next < runs.size() || !active.empty();) {
    if (observer.stop_requested()) return false;
    while (next < runs.size() && active.size() < static_cast<std::size_t>(settings.jobs)) {
      const RunTask& run = *runs[next++];
      const fs::path place = folder.run_folder(run);
      if (!is_due(folder.result_of(run), limits, settings.retry)) {
        if (!folder.is_whole()) remove_leftovers(place.string());
        continue;
      }
      RunResult result;
      result.fingerprint = run.fingerprint;
      result.limit_seconds = limits.seconds;
      result.limit_memory_mb = limits.memory_mb;
      result.jobs = settings.jobs;
      result.load = machine_load();
      result.machine = machine;
      result.program = program_version();
      observer.run_started(run);
      const ProcessLimits process_limits{limits.seconds, limits.grace_seconds,
                                         static_cast<std::uint64_t>(limits.memory_mb * 1e6)};
      active.push_back(std::make_unique<ActiveRun>(run, place.string(), program, process_limits, std::move(result)));
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    std::erase_if(active, [&](const std::unique_ptr<ActiveRun>& a) {
      if (!a->advance()) return false;
      observer.run_ended(a->run(), a->result());
      return true;
    });
  }
  return true;
}

}  // namespace shellmatch
