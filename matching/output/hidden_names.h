#pragma once
/// \file
/// Names of the hidden files beside an output folder during a run.

#include <string>
#include <string_view>

namespace shellmatch {

/// The lock that a run for the output folder `path` holds: `.NAME.lock` beside it. Of long names, which would leave no
/// room for that, the beginning and a checksum are used.
std::string lock_name(const std::string& path);

/// The hidden folder in which the output folder `path` is prepared: `.NAME.partial-PID` beside it.
std::string partial_folder_name(const std::string& path);

/// Ending of the hidden name of an output folder that is being replaced. After a kill between the two steps of a
/// replacement this is the only copy of the earlier result, so it is kept.
inline constexpr std::string_view set_aside = ".old";

/// Whether this is the name of a hidden folder of the output folder NAME: with numbers where a run has its process'.
bool is_partial_folder_name(std::string_view entry, const std::string& name);
/// The same, or the name of its lock.
bool is_hidden_name(std::string_view entry, const std::string& name);

/// NAME, for the name of a lock or a hidden folder; empty for any other name.
std::string name_of_output(std::string_view hidden);

}  // namespace shellmatch
