#pragma once
/// \file
/// The three kinds of failure. A programming error is an `assert`. A broken invariant that must stop even a
/// release build is a `SHELLMATCH_CHECK`. Bad input or a hostile environment is an exception whose text
/// names the file, key or element and says what to do; the program turns it into an exit code.

#include <fmt/core.h>

#include <stdexcept>
#include <string>
#include <string_view>

namespace shellmatch {

/// What the user gave cannot be used: exit code 2.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The machine does not give what is needed (disk, memory, permission): exit code 3.
class EnvironmentError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

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

/// Reports a broken invariant with its place and throws std::logic_error (exit code 70).
[[noreturn]] void invariant_failed(const char* condition, const char* file, int line, std::string_view what);

}  // namespace shellmatch

/// Stops, in every build, where `condition` does not hold.
#define SHELLMATCH_CHECK(condition, what)                                              \
  do {                                                                                 \
    if (!(condition)) ::shellmatch::invariant_failed(#condition, __FILE__, __LINE__, what); \
  } while (false)
