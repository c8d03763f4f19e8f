#pragma once
/// \file
/// The hidden files beside an output folder during a run, and their removal after a run that was killed.

#include <string>
#include <string_view>

namespace shellmatch {

/// The hidden folder in which the output folder `path` is prepared: the absolute path of `.NAME.partial-PID`.
std::string partial_folder_name(const std::string& path);

/// Removes the remains of killed runs for the output folder `path`, unless a run is working there.
/// \throws EnvironmentError if nothing can be written beside it
void remove_leftovers(const std::string& path);

/// The same for all output folders in `parent`, found by the names of locks and hidden folders. Each lock is held for a
/// moment while it is examined; \pre no run is about to start in `parent`. Files that cannot be removed stay.
void remove_leftovers_in(const std::string& parent);

/// The lock that a run for the output folder `path` holds: `.NAME.lock` beside it.
std::string lock_name(const std::string& path);

/// Removes the hidden folders beside the output folder `path`. \pre the caller holds its lock
void remove_partial_folders(const std::string& path);

/// Ending of the hidden name of an output folder that is being replaced. After a kill between the two steps of a
/// replacement this is the only copy of the earlier result, so it is kept.
inline constexpr std::string_view set_aside = ".old";

/// Whether there is anything at `path` other than an empty folder.
bool is_filled(const std::string& path);

}  // namespace shellmatch
