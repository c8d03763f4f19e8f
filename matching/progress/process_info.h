#pragma once
/// \file
/// What the machine gives and what this process has taken.

#include <cstdint>
#include <string>

namespace shellmatch {

/// Most memory that this process has held at a time, in bytes; 0 where the system does not tell.
std::uint64_t peak_memory_bytes();

/// Memory that could be taken now without swapping, in bytes, with the limits of a container heeded; 0 where
/// the system does not tell.
std::uint64_t available_memory_bytes();

/// Room on the disk that holds `path` or its nearest existing parent, in bytes; 0 where the system does not
/// tell.
std::uint64_t free_disk_bytes(const std::string& path);

/// Name and version of the compiler that made the program: "gcc 12.2.0".
std::string compiler_name();

/// The program's own version: "0.1.0".
std::string program_version();

}  // namespace shellmatch
