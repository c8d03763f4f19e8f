#pragma once
/// \file
/// Which files of a cohort's folder are the program's own: those that it may remove, and those that no input may be.

#include <string>
#include <string_view>

namespace shellmatch {

struct Cohort;

/// Removes the file if it begins with this line: a table of an earlier run. One of the same name that the user has put
/// there stays.
void remove_own_table(const std::string& path, std::string_view first_line);

/// The same of landmarks in a format for morphometrics, which begins with this.
void remove_own_landmarks(const std::string& path, std::string_view beginning);

/// What of the folder `model` is removed: what the present model lacks, and mode shapes, of which it may have fewer.
enum class StaleFiles { mode_shapes, statistics, all };

/// Removes files of an earlier model by their names: shapes and animations of single modes, and a mean of another
/// dimension; with `statistics` also mean, modes and scores; with `all` points and the folder itself, if it is empty
/// then. Other files belong to the user. \param dimension of the present model: 2 or 3
void remove_model_files(const std::string& folder, StaleFiles what, int dimension);

/// \throws InputError if a table, a shape, an atlas or a file of landmarks is one that the cohort is going to write in
/// this folder
void check_inputs_are_kept(const Cohort& cohort, const std::string& folder);

}  // namespace shellmatch
