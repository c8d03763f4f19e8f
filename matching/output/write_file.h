#pragma once
/// \file
/// Whole files to the disk, and what to say where it does not take them.

#include <string>
#include <string_view>

namespace shellmatch {

/// Writes a whole file. \throws EnvironmentError naming the file: disk full, no permission.
void write_file(const std::string& path, std::string_view contents);

/// Waits until the disk has all of a file or a folder's list of names. \throws EnvironmentError as write_file
void synchronise_file(const std::string& path);
void synchronise_folder(const std::string& path);

/// Throws EnvironmentError for the error number `error` of the operating system.
[[noreturn]] void cannot_write(const std::string& path, int error);

}  // namespace shellmatch
