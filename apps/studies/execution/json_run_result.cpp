#include "matching/json/json_members.h"
#include "matching/output/write_file.h"
#include "apps/studies/execution/run_result.h"

#include <fstream>
#include <iterator>

namespace shellmatch {

namespace {

constexpr const char* names[] = {"finished", "diverged", "failed", "crashed", "timed_out", "out_of_memory", "not_run"};

}  // namespace

SHELLMATCH_JSON(RunResult, message, exit_code, signal, fingerprint, seconds, peak_memory_bytes, load, limit_seconds,
                limit_memory_mb, jobs, machine, program)

std::string status_name(RunStatus status) { return names[static_cast<int>(status)]; }

void write_run_result(const RunResult& result, const std::string& path) {
  Json json{{"status", status_name(result.status)}};
  json.update(json_of(result));
  write_file(path, json_text(json));
}

std::optional<RunResult> read_run_result(const std::string& path) {
  std::ifstream in(path);
  if (!in) return std::nullopt;
  try {
    const Json json = parse_json(in);
    RunResult result;
    set_from_json(json, result);
    const std::string status = json.at("status").get<std::string>();
    for (int i = 0; i < static_cast<int>(std::size(names)); ++i)
      if (status == names[i]) result.status = static_cast<RunStatus>(i);
    return result;
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

}  // namespace shellmatch
