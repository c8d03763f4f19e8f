#pragma once
/// \file
/// Checks and writes the single file that `generate` and `apply` produce, and checks the files of reports.

#include "geometry/surface/surface.h"

#include <string>

namespace shellmatch {

/// Checks before any work is done that the file can be written. \throws InputError if it exists and `force` is false,
/// if it is a folder, a pipe or a device or lies in no folder, or if its extension stands for no format of that
/// dimension
void check_output_file(const std::string& path, int dimension, bool force);

/// The same for a report, whose extension is arbitrary. \throws InputError
void check_report_file(const std::string& path, bool force);

/// Writes a shape in the format of the file's extension, atomically. \throws EnvironmentError, and InputError if
/// `force` is false and the file has come into being since the check
void write_output_file(const std::string& path, const OriginalShape<2>& shape, bool force);
void write_output_file(const std::string& path, const OriginalShape<3>& shape, bool force);

/// Says in a line what the format of the file's extension does not hold of a shape, if anything.
void say_what_is_left_out(const std::string& path, const OriginalShape<3>& shape);

/// The same for a report. \throws as write_output_file
void write_report_file(const std::string& path, const std::string& text, bool force);

}  // namespace shellmatch
