// What a user sees on a terminal: one line that is rewritten, cut to the terminal's width, and one that stays for each
// level.
#include "apps/terminal/time_left.h"
#include "tests/apps/cli_harness.h"
#include "tests/matching/output/temporary_folder.h"

#include <gtest/gtest.h>

#include <poll.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <thread>

namespace shellmatch {
namespace {

using testing::TemporaryFolder;

struct Shown {
  int exit_code = -1;
  std::string text;  ///< all that reached the terminal
};

// Runs the program on a terminal of so many columns, whose driver ends lines with "\r\n".
Shown run_on_terminal(Words words, unsigned short columns) {
  words.insert(words.begin(), SHELLMATCH_PROGRAM);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  winsize size{};
  size.ws_row = 24;
  size.ws_col = columns;
  int terminal = -1;
  const pid_t pid = forkpty(&terminal, nullptr, nullptr, &size);
  if (pid == 0) {
    execv(arguments[0], arguments.data());
    _exit(127);
  }
  Shown shown;
  if (pid < 0) {
    ADD_FAILURE() << "no pseudo-terminal can be had (" << std::strerror(errno) << "); is /dev/pts mounted?";
    return shown;
  }
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60 * test::slowdown);
  std::array<char, 4096> buffer;
  pollfd ready{.fd = terminal, .events = POLLIN, .revents = 0};
  while (std::chrono::steady_clock::now() < end && poll(&ready, 1, 1000) >= 0) {
    if (ready.revents == 0) continue;
    const ssize_t n = read(terminal, buffer.data(), buffer.size());
    if (n <= 0) break;  // EIO: the program has ended
    shown.text.append(buffer.data(), static_cast<std::size_t>(n));
  }
  int status = 0;
  if (waitpid(pid, &status, WNOHANG) == 0) {
    usleep(200000);
    if (waitpid(pid, &status, WNOHANG) == 0) {
      kill(pid, SIGKILL);
      waitpid(pid, &status, 0);
    }
  }
  close(terminal);
  shown.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return shown;
}

// What was written between two carriage returns or line ends.
std::vector<std::string> pieces(const std::string& text) {
  std::vector<std::string> all(1);
  for (const char c : text)
    if (c == '\r' || c == '\n') all.emplace_back();
    else all.back() += c;
  return all;
}

const std::string clear_to_end = "\x1b[K";

TEST(Terminal, ALineIsRewrittenWithinItsWidthAndOneStaysForEachLevel) {
  const TemporaryFolder tmp;
  constexpr unsigned short columns = 50;
  const Shown shown =
      run_on_terminal({"match", "generate:sphere", "generate:ellipsoid/long", "-o", tmp / "o", "--levels", "3:7",
                       "--align", "none", "--set", "pictures=none", "--set", "report=false"},
                      columns);
  EXPECT_EQ(shown.exit_code, 0) << shown.text;
  std::size_t n_rewritten = 0, n_iterations = 0;
  std::vector<int> staying(8, 0);  // by level
  for (const std::string& piece : pieces(shown.text)) {
    const bool is_rewritten = piece.ends_with(clear_to_end) && piece.size() > clear_to_end.size();
    n_rewritten += is_rewritten;
    if (is_rewritten) {
      EXPECT_LT(piece.size() - clear_to_end.size(), columns) << piece;
    }
    n_iterations += is_rewritten && has(piece, "iteration") && has(piece, "energy");
    for (int level = 3; level <= 7; ++level)
      staying[static_cast<std::size_t>(level)] +=
          !is_rewritten && has(piece, "level " + std::to_string(level) + "/7") && has(piece, " iterations in ");
  }
  EXPECT_GE(n_rewritten, 3u) << shown.text;
  EXPECT_GE(n_iterations, 1u) << shown.text;
  for (int level = 3; level <= 7; ++level)
    EXPECT_EQ(staying[static_cast<std::size_t>(level)], 1) << "level " << level << " in " << shown.text;
  // Nothing that is to be rewritten is left behind on the last line.
  EXPECT_TRUE(shown.text.ends_with("\r\n")) << shown.text;
}

TEST(Terminal, EveryPhaseSaysThatItGoesOn) {
  const TemporaryFolder tmp;
  const auto words = [&](const char* reference, const char* target, const char* folder) {
    return Words{"match", reference, target, "-o", tmp / folder, "--levels", "3:4", "--threads", "1"};
  };
  const Shown shown = run_on_terminal(words("generate:leaf/deep", "generate:leaf/shallow", "plane"), 100);
  EXPECT_EQ(shown.exit_code, 0) << shown.text;
  for (const char* stage : {"\rreading", "\ralignment", "\rmatching", "\rmeasuring", "\rwriting", "\rwriting the page"})
    EXPECT_TRUE(has(shown.text, stage)) << stage << shown.text;
  EXPECT_FALSE(has(shown.text, "sigma")) << shown.text;
  // Elsewhere these are lines, and the parameters of minimisations belong to -v.
  const ProgramResult lines = run_program(words("generate:hand", "generate:hand/bent", "space"));
  for (const char* stage : {"alignment (", "matching (", "measuring (", "writing (", "level 4/4, step 1/"})
    EXPECT_TRUE(has(lines.err, stage)) << stage << lines.err;
  for (const char* detail : {"sigma", "c_vol", "margin", "step 2/"})
    EXPECT_FALSE(has(lines.err, detail)) << detail << lines.err;
}

TEST(Heartbeat, BeatsUntilItEnds) {
  std::atomic<int> n = 0;
  {
    const Heartbeat heart([&] { ++n; });
    std::this_thread::sleep_for(std::chrono::milliseconds(2500));
  }
  const int beats = n;
  EXPECT_GE(beats, 1);
  std::this_thread::sleep_for(std::chrono::milliseconds(1200));
  EXPECT_EQ(n, beats);
}

TEST(Terminal, CheckedDerivativesAreSilentThereAndAreSaidElsewhere) {
  const TemporaryFolder tmp;
  const auto words = [&](const char* folder) {
    return Words{"match",        "generate:leaf", "generate:leaf/shallow",
                 "-o",           tmp / folder,    "--levels",
                 "3:4",          "--align",       "none",
                 "--set",        "pictures=none", "--set",
                 "report=false", "--set",         "check_gradient.every=1"};
  };
  const Shown shown = run_on_terminal(words("terminal"), 80);
  EXPECT_EQ(shown.exit_code, 0) << shown.text;
  EXPECT_FALSE(has(shown.text, "derivatives")) << shown.text;
  const ProgramResult elsewhere = run_program(words("elsewhere"));
  EXPECT_EQ(elsewhere.exit_code, 0) << elsewhere.err;
  EXPECT_TRUE(has(elsewhere.err, "iteration 1: derivatives checked")) << elsewhere.err;
}

TEST(Terminal, VerboseSaysEveryIterationAndRewritesNothing) {
  const TemporaryFolder tmp;
  const Shown shown =
      run_on_terminal({"match", "generate:circle", "generate:ellipse", "-o", tmp / "o", "--levels", "3:4", "--align",
                       "none", "-v", "--set", "pictures=none", "--set", "report=false"},
                      200);
  EXPECT_EQ(shown.exit_code, 0) << shown.text;
  EXPECT_FALSE(has(shown.text, clear_to_end)) << shown.text;
  EXPECT_TRUE(has(shown.text, "iteration 1: energy ")) << shown.text;
  EXPECT_TRUE(has(shown.text, "gradient ")) << shown.text;
}

}  // namespace
}  // namespace shellmatch
