#include "matching/output_folder.h"
#include "studies/run_result.h"

#include <nlohmann/json.hpp>

#include <fstream>
#include <iterator>

namespace shellmatch {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* names[] = {"finished",  "diverged",      "failed", "crashed",
                                 "timed_out", "out_of_memory", "not_run"};

// One list of members serves writing and reading.
template <class Result, class Member>
void describe(Result& r, Member&& member) {
  member("message", r.message), member("exit_code", r.exit_code), member("signal", r.signal);
  member("fingerprint", r.fingerprint), member("seconds", r.seconds),
      member("peak_memory_bytes", r.peak_memory_bytes);
  member("limit_seconds", r.limit_seconds), member("limit_memory_mb", r.limit_memory_mb),
      member("jobs", r.jobs);
  member("load", r.load), member("machine", r.machine), member("program", r.program);
}

}  // namespace

std::string status_name(RunStatus status) { return names[static_cast<int>(status)]; }

void write_run_result(const RunResult& result, const std::string& path) {
  Json json{{"status", status_name(result.status)}};
  describe(result, [&](const char* key, const auto& value) { json[key] = value; });
  // The program's words may hold any bytes.
  write_file(path, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

std::optional<RunResult> read_run_result(const std::string& path) {
  std::ifstream in(path);
  if (!in) return std::nullopt;
  const Json json = Json::parse(in, nullptr, false);
  if (!json.is_object()) return std::nullopt;
  try {
    RunResult result;
    const std::string status = json.at("status").get<std::string>();
    for (int i = 0; i < static_cast<int>(std::size(names)); ++i)
      if (status == names[i]) result.status = static_cast<RunStatus>(i);
    describe(result, [&]<class T>(const char* key, T& value) { value = json.at(key).get<T>(); });
    return result;
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

}  // namespace shellmatch
