#pragma once
/// \file
/// Removal of the hidden files that a killed run has left beside its output folder (matching/output/hidden_names.h).

#include <string>

namespace shellmatch {

/// Removes the remains of killed runs for the output folder `path`, unless a run is working there.
/// \throws EnvironmentError if nothing can be written beside it
void remove_leftovers(const std::string& path);

/// The same where nobody else works, as within the folder of a run that has ended, and the lock as well. Nothing is
/// thrown.
void remove_hidden(const std::string& path) noexcept;

/// The same as remove_leftovers() for all output folders in `parent`, found by the names of locks and hidden folders.
/// Each lock is held for a moment while it is examined; \pre no run is about to start in `parent`. Files that cannot be
/// removed stay.
void remove_leftovers_in(const std::string& parent);

/// Removes the hidden folders beside the output folder `path`. \pre the caller holds its lock
/// \param is_replaced whether a whole result (holds_result()) has taken the place of an earlier one that was set aside
void remove_partial_folders(const std::string& path, bool is_replaced);

/// Whether there is anything at `path` other than a folder that is empty but for its own lock and hidden folders: a
/// file, a link that leads nowhere, or a folder that cannot be looked into as well.
bool is_filled(const std::string& path);

}  // namespace shellmatch
