#pragma once
/// \file
/// Resources of the machine and of this process.

#include <cstdint>
#include <string>

namespace shellmatch {

/// Peak resident memory of this process in bytes; 0 if unknown.
std::uint64_t peak_memory_bytes();

/// Resident memory in bytes of the process with this number, "self" being this one; 0 if unknown.
std::uint64_t resident_memory_bytes(const std::string& process = "self");

/// Gives memory that has been freed back to the system, where the allocator can: it keeps holes between what is in use.
/// Call it before a phase that needs much for long.
void return_freed_memory();

/// The resident memory in bytes that the user has given to this process; 0 means all that there is. The runs of a study
/// and the estimates of a matching keep to it; apps/process/limits.h ends a command that exceeds it.
std::uint64_t memory_limit_bytes();
void set_memory_limit_bytes(std::uint64_t bytes);

/// Memory in bytes that can be allocated without swapping, within the limits of a container; 0 if unknown.
std::uint64_t available_memory_bytes();

/// Free space in bytes on the disk that holds `path` or its nearest existing parent; 0 if unknown.
std::uint64_t free_disk_bytes(const std::string& path);

/// Name and version of the compiler of this program: "gcc 12.2.0".
std::string compiler_name();

/// The vector units that this program's code is compiled for, and how: "AVX-512 (-march=native)", "SSE2". In a package
/// of several variants (cmake/Package.cmake) it is that of the variant that runs.
std::string vector_code();

/// The version of this program: "0.1.0".
std::string program_version();

}  // namespace shellmatch
