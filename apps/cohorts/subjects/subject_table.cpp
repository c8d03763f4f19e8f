#include "apps/cohorts/subjects/subject_table.h"

#include "base/error.h"
#include "base/text.h"
#include "geometry/io/input_file.h"
#include "geometry/mesh_text/read_text.h"
#include "geometry/volume/volume_name.h"
#include "matching/experiment/generated_source.h"
#include "matching/experiment/several_errors.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <glob.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <memory>

namespace shellmatch {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_told = 10;  // files that are missing

constexpr std::array known_columns = {"id", "file", "landmarks", "group", "reflect"};

// "scans/a1.nii.gz:3" becomes "a1_3", "generate:hand/bent" becomes "hand_bent".
std::string id_of_source(const std::string& source) {
  if (is_generated_source(source)) return safe_file_name(source.substr(source.find(':') + 1));
  std::string name = fs::path(source).filename().string();
  const std::size_t colon = name.find(':');
  const std::string label = colon == std::string::npos ? "" : "_" + name.substr(colon + 1);
  name = name.substr(0, colon);
  for (const std::string_view ending : {".nii.gz", ".gz"})
    if (name.size() > ending.size() && name.ends_with(ending))
      return safe_file_name(name.substr(0, name.size() - ending.size()) + label);
  return safe_file_name(fs::path(name).stem().string() + label);
}

std::string absolute_source(const std::string& source, const fs::path& folder) {
  return is_generated_source(source) ? source : fs::absolute(folder / source).lexically_normal().string();
}

bool is_true(const std::string& text, const LineReader& reader) {
  for (const std::string_view word : {"1", "yes", "true"})
    if (equals_ignoring_case(text, word)) return true;
  for (const std::string_view word : {"", "0", "no", "false"})
    if (equals_ignoring_case(text, word)) return false;
  reader.fail("reflect is '{}'; expected 0 or 1", text);
}

// A line of the table.
Subject subject_of(const std::vector<std::string>& columns, const std::vector<std::string>& fields,
                   const LineReader& reader, const fs::path& folder) {
  if (fields.size() != columns.size())
    reader.fail("{} values where the head line has {} columns ({})", fields.size(), columns.size(),
                fmt::format("{}", fmt::join(columns, ",")));
  Subject subject;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const std::string &name = columns[k], &text = fields[k];
    if (name == "id") subject.id = text;
    else if (name == "file") subject.source = text;
    else if (name == "landmarks")
      subject.landmarks = text.empty() ? "" : fs::absolute(folder / text).lexically_normal().string();
    else if (name == "group") subject.group = text;
    else if (name == "reflect") subject.reflect = is_true(text, reader);
    else subject.further.emplace_back(name, text);
  }
  if (subject.source.empty()) reader.fail("the name of the file is empty");
  if (std::error_code error;
      !subject.landmarks.empty() && !fs::is_regular_file(split_part(subject.landmarks).file, error))
    reader.fail("{}: there is no such file of landmarks", subject.landmarks);
  if (subject.id.empty()) subject.id = id_of_source(subject.source);
  subject.source = absolute_source(subject.source, folder);
  return subject;
}

std::vector<std::string> read_head(const LineReader& reader) {
  std::vector<std::string> columns;
  for (const std::string_view field : csv_fields(reader.line())) {
    std::string name = csv_text(field);
    for (const std::string_view known : known_columns)
      if (equals_ignoring_case(name, known)) name = known;
    if (std::ranges::find(columns, name) != columns.end()) reader.fail("two columns are named '{}'", name);
    columns.push_back(std::move(name));
  }
  if (std::ranges::find(columns, "file") == columns.end())
    reader.fail("there is no column 'file'; expected a head line with some of {}",
                fmt::format("{}", fmt::join(known_columns, ",")));
  return columns;
}

// The files of a pattern, in the order of their names.
std::vector<std::string> files_of_pattern(const std::string& pattern) {
  glob_t found{};
  const std::unique_ptr<glob_t, decltype(&globfree)> owner(&found, globfree);
  if (glob(pattern.c_str(), 0, nullptr, &found) != 0) return {};
  std::vector<std::string> files(found.gl_pathv, found.gl_pathv + found.gl_pathc);
  std::ranges::sort(files);  // glob's own order depends on the language that the user has set
  return files;
}

}  // namespace

std::vector<Subject> read_subject_table(const std::string& path) {
  const std::string text = InputFile(path).read();
  LineReader reader(path, text, 0);
  if (!reader.next())
    throw_input_error("{}: is empty; expected a head line with the names of the columns, as id,file,group", path);
  const std::vector<std::string> columns = read_head(reader);
  const fs::path folder = fs::absolute(path).parent_path();
  std::vector<Subject> subjects;
  std::vector<std::size_t> lines;
  while (reader.next()) {
    std::vector<std::string> fields;
    for (const std::string_view field : csv_fields(reader.line())) fields.push_back(csv_text(field));
    subjects.push_back(subject_of(columns, fields, reader, folder));
    lines.push_back(reader.number());
  }
  if (subjects.empty()) throw_input_error("{}: has no subject below its head line", path);
  check_subjects(subjects, path, lines);
  return subjects;
}

std::vector<Subject> subjects_of(const std::vector<std::string>& names, const std::string& where) {
  std::vector<Subject> subjects;
  const auto add = [&](const std::string& source) {
    Subject subject;
    subject.id = id_of_source(source);
    subject.source = absolute_source(source, fs::current_path());
    subjects.push_back(std::move(subject));
  };
  for (const std::string& name : names) {
    std::error_code error;
    if (is_generated_source(name) || name.find_first_of("*?") == std::string::npos || fs::exists(name, error)) {
      add(name);
      continue;
    }
    const std::vector<std::string> files = files_of_pattern(name);
    if (files.empty()) throw_input_error("{}: {}: no file has such a name", where, name);
    for (const std::string& file : files) add(file);
  }
  check_subjects(subjects, where);
  return subjects;
}

void check_subjects(const std::vector<Subject>& subjects, const std::string& where,
                    const std::vector<std::size_t>& lines) {
  std::map<std::string, std::size_t> number_of;
  for (std::size_t k = 0; k < subjects.size(); ++k) {
    const Subject& subject = subjects[k];
    if (subject.id.empty() || subject.id.size() > 200 || subject.id != safe_file_name(subject.id) ||
        subject.id.starts_with('.') || subject.id.starts_with('-'))
      throw_input_error(
          "{}{}: the id '{}' cannot be the name of a folder; expected 1 to 200 letters, digits and ._+-=, "
          "not . or - first",
          where, lines.empty() ? "" : fmt::format(", line {}", lines[k]), subject.id.substr(0, 220));
    const auto [at, is_new] = number_of.emplace(subject.id, k);
    if (is_new) continue;
    const std::string& other = subjects[at->second].source;
    if (lines.empty())
      throw_input_error("{}: two subjects have the id {}: {} and {}; give them ids in a table", where, subject.id,
                        other, subject.source);
    throw_input_error(
        "{}, lines {} and {}: two subjects have the id {}: {} and {}; ids must differ: change the "
        "column id (where that is missing or empty, the file's name is the id)",
        where, lines[at->second], lines[k], subject.id, other, subject.source);
  }
}

void check_files(const std::vector<Subject>& subjects, const std::string& where) {
  std::vector<std::string> wrong;
  for (const Subject& subject : subjects) {
    try {
      if (is_generated_source(subject.source)) check_generated_source(subject.source);
      else InputFile(file_of(subject.source));
    } catch (const InputError& error) {
      wrong.push_back(fmt::format("{}: subject {}: {}", where, subject.id, error.what()));
    }
  }
  if (wrong.empty()) return;
  if (wrong.size() > most_told) {
    const std::size_t further = wrong.size() - most_told;
    wrong.resize(most_told);
    wrong.push_back(fmt::format("{}: and the files of {} further subjects", where, further));
  }
  throw SeveralInputErrors(std::move(wrong));
}

}  // namespace shellmatch
