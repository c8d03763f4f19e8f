#pragma once
/// \file
/// What the program ends with (docs/limits.md). A process that a signal ends has 128 + its number.

namespace shellmatch::exit_code {

inline constexpr int success = 0;
inline constexpr int check_failed = 1;  ///< a check of derivatives, of the installation or of a verdict (--fail-on)
inline constexpr int input_error = 2;   ///< InputError: the user's input cannot be used
inline constexpr int environment_error = 3;  ///< EnvironmentError: the machine lacks a resource or permission
inline constexpr int limit_reached = 4;      ///< --max-seconds, --max-memory
inline constexpr int memory_error = 5;       ///< MemoryError: there is not enough memory
inline constexpr int disk_error = 6;         ///< DiskError: there is no room on the disk
inline constexpr int internal_error = 70;    ///< an invariant does not hold

}  // namespace shellmatch::exit_code
