// `shellmatch view`: the page of a result is found, and handed to the desktop where there is one.

#include "tests/apps/cli_harness.h"
#include "tests/matching/output/temporary_folder.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <thread>

namespace shellmatch {
namespace {

namespace fs = std::filesystem;
using testing::contents_of;
using testing::put;
using testing::TemporaryFolder;

struct View : ::testing::Test {
  View() {
    run_program({"match", "generate:circle", "generate:ellipse", "-o", tmp / "o", "--levels", "3:3", "--align", "none",
                 "--set", "pictures=none", "-q"});
  }
  const TemporaryFolder tmp;
  const std::string page = fs::canonical(tmp / ".").string() + "/o/report.html";
};

// An xdg-open of ours, which keeps what it is given.
Words with_desktop(const TemporaryFolder& tmp, const std::string& display) {
  fs::create_directories(tmp / "bin");
  put(tmp / "bin/xdg-open", "#!/bin/sh\nprintf '%s' \"$1\" > " + (tmp / "opened.new") + "\nmv " + (tmp / "opened.new") +
                                " " + (tmp / "opened") + "\n");
  fs::permissions(tmp / "bin/xdg-open", fs::perms::owner_all);
  return {"PATH=" + (tmp / "bin") + ":" + std::getenv("PATH"), "DISPLAY=" + display, "WAYLAND_DISPLAY="};
}

ProgramResult view_with(const Words& environment, const Words& words) {
  return run_in_child(words, [&] {
    for (const std::string& setting : environment) {
      const std::size_t sign = setting.find('=');
      if (::setenv(setting.substr(0, sign).c_str(), setting.substr(sign + 1).c_str(), 1) != 0) return false;
    }
    return true;
  });
}

bool appears(const std::string& file) {
  for (int i = 0; i < 200 && !fs::exists(file); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  return fs::exists(file);
}

TEST_F(View, OpensThePageWhereThereIsADesktop) {
  const ProgramResult result = view_with(with_desktop(tmp, ":7"), {"view", tmp / "o"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  ASSERT_TRUE(appears(tmp / "opened"));
  EXPECT_EQ(fs::canonical(contents_of(tmp / "opened")), page);
}

TEST_F(View, SaysWhatToOpenWhereThereIsNone) {
  const ProgramResult result = view_with(with_desktop(tmp, ""), {"view", tmp / "o"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(has(result.err, "open this file in a browser")) << result.err;
  EXPECT_FALSE(fs::exists(tmp / "opened"));
  const ProgramResult printed = run_program({"view", tmp / "o/report.html", "--print"});
  EXPECT_EQ(printed.exit_code, 0);
  EXPECT_EQ(printed.err, "");
  EXPECT_EQ(fs::canonical(printed.out.substr(0, printed.out.size() - 1)), page);
}

TEST_F(View, RefusesWhatHasNoPage) {
  fs::remove(page);
  fs::create_directories(tmp / "empty");
  for (const auto& [what, words] : {std::pair<std::string, std::string>{tmp / "o", "report=true"},
                                    {tmp / "empty", "not the output folder of a run"},
                                    {tmp / "gone", "is not there"},
                                    {tmp / "o/summary.json", "is no report"}}) {
    const ProgramResult result = run_program({"view", what, "--print"});
    EXPECT_EQ(result.exit_code, 2) << what;
    EXPECT_TRUE(has(result.err, words)) << result.err;
    EXPECT_EQ(result.out, "");
  }
}

}  // namespace
}  // namespace shellmatch
