#pragma once
/// \file
/// What stands hidden beside an output folder while a run works on it, and what a run that was killed leaves of it.

#include <string>
#include <string_view>

namespace shellmatch {

/// The hidden name beside the output folder `path` under which it is worked on: the absolute path of
/// `.NAME.partial-PID`.
std::string partial_folder_name(const std::string& path);

/// Removes what killed runs have left of the output folder `path`, hidden beside it, unless a run is at work there.
/// \throws EnvironmentError if nothing can be written beside it
void remove_leftovers(const std::string& path);

/// The same for every output folder in `parent`, by the names of the locks and hidden folders that are there. A lock
/// is held for a moment while it is looked at, so nobody may be about to start a run in `parent`. What cannot be removed stays.
void remove_leftovers_in(const std::string& parent);

/// The lock beside the output folder `path` that a run holds while it works there: `.NAME.lock`.
std::string lock_name(const std::string& path);

/// Removes the hidden folders beside the output folder `path`. \pre the caller holds its lock
void remove_partial_folders(const std::string& path);

/// Ends the hidden name of an output folder that is being replaced. Of a run that was killed between the two steps of a
/// replacement, it is all that there is of the earlier result, and stays.
inline constexpr std::string_view set_aside = ".old";

/// Is there something at `path` besides an empty folder?
bool is_filled(const std::string& path);

}  // namespace shellmatch
