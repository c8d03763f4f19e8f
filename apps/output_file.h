#pragma once
/// \file
/// The one file that `generate` and `apply` write, and reports.

#include "geometry/surface/surface.h"

#include <string>

namespace shellmatch {

/// Refuses, before any work is done, a file that cannot be written: one that exists without `force`, a
/// folder, a file in no folder, an ending that stands for no format of that dimension. \throws InputError
void check_output_file(const std::string& path, int dimension, bool force);

/// The same for a report of any ending. \throws InputError
void check_report_file(const std::string& path, bool force);

/// By the ending of the name; whole or not at all. \throws EnvironmentError
void write_output_file(const std::string& path, const OriginalShape<2>& shape);
void write_output_file(const std::string& path, const OriginalShape<3>& shape);

}  // namespace shellmatch
