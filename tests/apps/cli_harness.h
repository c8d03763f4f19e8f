#pragma once
/// \file
/// Runs the real program as a user would.

#include "tests/support/slowdown.h"

#include <chrono>
#include <functional>
#include <string>
#include <vector>

namespace shellmatch {

using Words = std::vector<std::string>;  ///< of a command line

struct ProgramResult {
  int exit_code = -1;  ///< 128 + signal where a signal ended it
  std::string out, err;
  bool timed_out = false;  ///< it was killed
};

/// A process that was started; killed and awaited at the latest when this object goes.
class Program {
 public:
  /// \param words   those after the program's name
  /// \param folder  working folder; empty for the present one
  explicit Program(const Words& words, const std::string& folder = "");
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void send_signal(int signal) const;
  /// Waits until the program has a handler for the signal; false if the time is over before.
  bool wait_for_handler(int signal, std::chrono::milliseconds limit = std::chrono::seconds(60 * test::slowdown)) const;
  /// Collects its output until it ends or the time is over.
  ProgramResult wait(std::chrono::milliseconds limit = std::chrono::seconds(60 * test::slowdown));
  /// Collects until `text` has appeared on stderr; false if the program ended or the time was over before.
  bool wait_for_stderr(const std::string& text,
                       std::chrono::milliseconds limit = std::chrono::seconds(60 * test::slowdown));

 private:
  bool collect(std::chrono::steady_clock::time_point deadline);

  int pid_ = -1, out_fd_ = -1, err_fd_ = -1;
  ProgramResult result_;
};

inline bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// The last line of a text that ends in one.
std::string last_line(const std::string& text);

/// Starts the program and waits for its end.
ProgramResult run_program(const std::vector<std::string>& words, const std::string& folder = "",
                          std::chrono::milliseconds limit = std::chrono::seconds(60 * test::slowdown));

/// Starts the program in a process that `prepare` has changed: limits and rights cannot be taken back. Its exit code
/// (128 + signal) and stderr.
ProgramResult run_in_child(const Words& words, const std::function<bool()>& prepare);

/// For run_in_child(): the rights of root that go beyond those of a file's owner are given up; others have none.
bool obey_permissions();

}  // namespace shellmatch
