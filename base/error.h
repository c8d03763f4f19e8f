#pragma once
/// \file
/// The three kinds of failure. A programming error is an `assert`. A violated invariant that must stop a
/// release build as well is a `SHELLMATCH_CHECK`. Bad input and a lack of resources are exceptions, whose
/// text names the file, key or element and says what to do; the program converts them to exit codes.

#include <fmt/core.h>

#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace shellmatch {

/// The text with an escape in place of each NUL, with which the text of an exception ends.
std::string without_nul(std::string text);

/// The user's input cannot be used: exit code 2.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::string text) : std::runtime_error(without_nul(std::move(text))) {}
};

/// The machine lacks a resource or permission: exit code 3, or that of a kind below.
class EnvironmentError : public std::runtime_error {
 public:
  explicit EnvironmentError(std::string text) : std::runtime_error(without_nul(std::move(text))) {}
};

/// There is not enough memory for something that the text names: exit code 5. A command for which the user has set a
/// limit of memory ends as at that limit.
class MemoryError : public EnvironmentError {
 public:
  using EnvironmentError::EnvironmentError;
};

/// Nothing more can be written, as far as is known for want of room on the disk: exit code 6.
class DiskError : public EnvironmentError {
 public:
  using EnvironmentError::EnvironmentError;
};

/// Throws DiskError, or EnvironmentError where the system's error number names another cause. \param error 0: unknown
[[noreturn]] void cannot_be_written(int error, const std::string& text);

/// Throws InputError with a formatted text: `throw_input_error("{}: no faces; ...", path)`.
template <class... Args>
[[noreturn]] void throw_input_error(fmt::format_string<Args...> text, Args&&... args) {
  throw InputError(fmt::format(text, std::forward<Args>(args)...));
}

/// Throws EnvironmentError with a formatted text.
template <class... Args>
[[noreturn]] void throw_environment_error(fmt::format_string<Args...> text, Args&&... args) {
  throw EnvironmentError(fmt::format(text, std::forward<Args>(args)...));
}

/// Throws std::logic_error with the violated invariant and its file and line (exit code 70).
[[noreturn]] void invariant_failed(const char* condition, const char* file, int line, std::string_view what);

}  // namespace shellmatch

/// Throws, in every build, unless `condition` holds.
#define SHELLMATCH_CHECK(condition, what)                                                   \
  do {                                                                                      \
    if (!(condition)) ::shellmatch::invariant_failed(#condition, __FILE__, __LINE__, what); \
  } while (false)
