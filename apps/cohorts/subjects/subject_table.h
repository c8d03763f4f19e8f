#pragma once
/// \file
/// The subjects of a cohort: from a table, or from names of files.

#include "apps/cohorts/subjects/subject.h"

#include <string>
#include <vector>

namespace shellmatch {

/// Reads a CSV file with a head line. Columns: `file`, needed; `id`, by default made of the file's name;
/// `landmarks`, `group`, `reflect` (0 or 1, no or yes); others are kept. Paths are relative to the table.
/// \throws InputError with file and line
std::vector<Subject> read_subject_table(const std::string& path);

/// The subjects of files, built-in shapes and patterns with * and ?, each in the order of names. \param where
/// the beginning of messages \throws InputError for a pattern that no file has
std::vector<Subject> subjects_of(const std::vector<std::string>& names, const std::string& where);

/// Checks that ids differ and can be names of files. \param lines numbers, from 1, of the table's line of each subject;
/// empty without a table \throws InputError
void check_subjects(const std::vector<Subject>& subjects, const std::string& where,
                    const std::vector<std::size_t>& lines = {});

/// Checks that the file or built-in shape of each subject exists; its contents are not read. \throws
/// SeveralInputErrors, one text for each
void check_files(const std::vector<Subject>& subjects, const std::string& where);

}  // namespace shellmatch
