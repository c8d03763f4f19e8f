#pragma once
/// \file
/// Runs that are stopped where a test wants it, and the comparison of what they write.

#include "base/stop.h"
#include "matching/output/history_file.h"
#include "matching/output/summary.h"
#include "matching/run_matching.h"
#include "tests/matching/output/temporary_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace shellmatch::testing {

inline ExperimentOptions experiment(Pictures pictures = Pictures::none) {
  ExperimentOptions o = profile_defaults(Profile::standard);
  o.align.mode = AlignMode::none;
  o.input.reference = "generate:circle";
  o.input.template_file = "generate:ellipse/long";
  o.cascade.max_level = 5;
  o.pictures = pictures;
  o.report = false;  // which has times
  o.resume.min_seconds = 0;
  return o;
}

// Does something as a level begins, or as the result is written (level 100), and keeps what it is told.
struct Watcher : Observer {
  int level = 0;
  std::function<void(int)> action = [](int) {};
  std::string notes;
  std::vector<int> levels;
  int n_of_trials = 0, most_of_trials = -1;  // iterations; after the most it stops
  void trial_iterated() override {
    if (++n_of_trials == most_of_trials) throw Stopped("now");
  }
  void note(const std::string& text) override { notes += text + "\n"; }
  void stage(const std::string& name) override {
    if (name == "writing") action(100);
  }
  void minimisation_started(const LevelStart& start) override {
    if (start.level == level) return;
    level = start.level;
    levels.push_back(level);
    action(level);
  }
};

// Runs until the level begins. Returns what is told of the stop.
inline std::string stop_at(int level, const ExperimentOptions& options, const std::string& out,
                           Watcher&& watcher = {}) {
  watcher.action = [level](int begins) {
    if (begins == level) throw Stopped("now");
  };
  return message_of<Stopped>([&] { run_matching(options, out, {}, watcher); });
}

inline Watcher run(const ExperimentOptions& options, const std::string& out, const EarlierRuns& earlier = {}) {
  Watcher watcher;
  run_matching(options, out, earlier, watcher);
  return watcher;
}

// The contents of all files, without times and memory.
inline std::map<std::string, std::string> lasting(const std::string& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file() || entry.path().filename() == "files.json") continue;  // which has checksums of times
    const std::string name = std::filesystem::relative(entry.path(), folder).string();
    if (name == "summary.json") {
      MatchSummary s = read_summary(entry.path());
      s.run = {};
      files[name] = summary_json(s);
    } else if (name == "history.csv") {
      History history = read_history(entry.path());
      for (HistoryRow& row : history.rows) row.record.seconds = 0;
      files[name] = history_csv(history);
    } else {
      files[name] = contents_of(entry.path());
    }
  }
  return files;
}

inline void expect_same_bits(const std::string& a, const std::string& b) {
  const auto first = lasting(a), second = lasting(b);
  EXPECT_EQ(first.size(), second.size());
  for (const auto& [name, contents] : first)
    EXPECT_TRUE(second.contains(name) && second.at(name) == contents) << name << " differs";
}

}  // namespace shellmatch::testing
