#pragma once
/// \file
/// The copy of a study's or a cohort's file in the folder of its results.

#include <string>

namespace shellmatch {

/// Empty where the file cannot be read.
std::string contents_of(const std::string& file);

/// \throws InputError if the file exists, says something else than `text`, and is no copy of ours: it is somebody's
void check_copy_place(const std::string& path, const std::string& text);

/// Writes the text, with a last line by which the copy is known; a file of the user's that says the same stays.
/// \throws InputError as check_copy_place(), EnvironmentError if it cannot be written
void keep_copy(const std::string& path, const std::string& text);

}  // namespace shellmatch
