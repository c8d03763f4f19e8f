#pragma once
/// \file
/// Whether the tests and the program run under a sanitizer, which takes memory of its own, catches signals, and takes many times as
/// long: limits of memory and time then say nothing about the program.

namespace shellmatch::test {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool is_sanitized = true;
#else
inline constexpr bool is_sanitized = false;
#endif

}  // namespace shellmatch::test

/// Ends a test of such limits there. The reason is a part of the output.
#define SHELLMATCH_SKIP_IF_SANITIZED(what) \
  if (::shellmatch::test::is_sanitized) GTEST_SKIP() << "under a sanitizer " what
