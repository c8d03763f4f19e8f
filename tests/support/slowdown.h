#pragma once
/// \file
/// How many times as long as usual a test may take.

namespace shellmatch::test {

/// 1, or 20 with sanitizers and in the preset `coverage` (tests/CMakeLists.txt).
inline constexpr int slowdown = SHELLMATCH_SLOWDOWN;

}  // namespace shellmatch::test
