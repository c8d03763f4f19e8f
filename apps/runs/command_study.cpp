// `study`: performs the runs that a file describes, and evaluates them.

#include "apps/commands.h"
#include "apps/process/interrupt.h"
#include "apps/process/limits.h"
#include "apps/runs/runs.h"
#include "apps/studies/report/study_report.h"
#include "base/error.h"
#include "base/printable.h"
#include "base/stop.h"
#include "matching/experiment/option_text.h"
#include "matching/experiment/yaml_document.h"
#include "matching/progress/process_info.h"

#include <filesystem>
#include <iostream>
#include <optional>

namespace shellmatch {

namespace {

// The runs of these names, in their order; all runs if `only` is empty.
std::vector<StudyRun> chosen(const std::vector<StudyRun>& runs, const std::vector<std::string>& only) {
  if (only.empty()) return runs;
  std::vector<std::string> names;
  for (const StudyRun& run : runs) names.push_back(run.name);
  std::vector<StudyRun> list;
  for (const std::string& name : only) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) {
      const std::string near = nearest_word(name, names);
      throw_input_error("--only {}: the study has no such run; {}--list lists them", name,
                        near.empty() ? "" : fmt::format("did you mean {}? ", near));
    }
    const StudyRun& run = runs[static_cast<std::size_t>(found - names.begin())];
    if (std::ranges::find(list, run.name, &StudyRun::name) == list.end()) list.push_back(run);
  }
  return list;
}

// What the text of a study says of its folder; none where it says nothing or is no study.
std::optional<std::string> folder_in(const std::string& text) {
  try {
    for (const auto& [key, value] : YamlDocument::from_text(text, "study").tree().entries)
      if (key == "folder") return value.text;
  } catch (const InputError&) {
  }
  return std::nullopt;
}

// The study's text with the folder to which its paths are relative, so that the copy can be run from where it lies.
// Unchanged where the text names a folder, or has a form in which none can be added.
std::string text_of_copy(const Study& study) {
  const std::string text = contents_of(study.file);
  if (folder_in(text)) return text;
  const std::string& chosen = study.options.folder;
  const std::string folder =
      chosen.empty() ? std::filesystem::absolute(study.file).parent_path().lexically_normal().string() : chosen;
  const std::string entry = "folder: " + scalar_text(folder, OptionKind::text);
  // A map in braces, or one with a key on each line.
  std::size_t begin = 0;
  while (begin < text.size() && (std::isspace(static_cast<unsigned char>(text[begin])) != 0 || text[begin] == '#'))
    begin = text[begin] == '#' ? std::min(text.find('\n', begin), text.size()) : begin + 1;
  std::string copy = text;
  if (begin < text.size() && text[begin] == '{') {
    copy.insert(begin + 1, entry + ", ");
  } else {
    const std::size_t line = text.rfind('\n', begin);
    const std::string indentation(begin - (line == std::string::npos ? 0 : line + 1), ' ');
    if (!copy.empty() && copy.back() != '\n') copy += '\n';
    copy += indentation + entry + "\n";
  }
  return folder_in(copy) == folder ? copy : text;
}

// The study's own file may lie where its results go.
bool is_file_in(const std::string& file, const std::string& folder) {
  std::error_code error;
  return std::filesystem::equivalent(file, std::filesystem::path(folder) / "study.yaml", error);
}

void list(const Study& study, const std::vector<StudyRun>& runs, bool verbose) {
  for (const StudyRun& run : runs) {
    std::cout << run.name;
    if (verbose)
      std::cout << fmt::format("\t{}\t{:g}\t{:g}", run.options.threads, study.options.limits.seconds,
                               study.options.limits.memory_mb);
    std::cout << "\n";
  }
}

}  // namespace

void execute(const StudyCommand& command) {
  std::vector<Override> overrides;
  for (const std::string& assignment : command.assignments) overrides.push_back(parse_override(assignment));
  if (command.collect && !command.only.empty()) throw_input_error("--collect is for the whole study, not for --only");
  Study study = read_study(command.study, std::move(overrides));
  const std::vector<StudyRun> all = runs_of(study), runs = chosen(all, command.only);
  const TaskSettings settings{checked_program(command.program), number_of_jobs(command.jobs, 1), command.retry};
  keep_memory_of_runs(study.options.limits, settings.jobs);
  if (command.list) return list(study, runs, command.verbosity == Verbosity::verbose);

  const std::string output =
      command.output.empty() ? "out/" + std::filesystem::path(command.study).stem().string() : command.output;
  const bool is_its_own = is_file_in(study.file, output);
  const std::string text = is_its_own ? contents_of(study.file) : text_of_copy(study);
  if (!is_its_own) check_copy_place(output + "/study.yaml", text);
  const RunsFolder folder(output, study_folder_kind, command.only.empty());
  if (!is_its_own) keep_copy(folder.path() + "/study.yaml", text);
  catch_interrupts();
  RunsProgress progress(command.verbosity == Verbosity::quiet);
  if (!command.collect && !run_tasks(tasks_of(runs), study.options.limits, folder, settings, progress))
    throw Stopped(fmt::format("stopped; the same command goes on where it was (results so far: {})", output),
                  stop_cause());
  if (command.only.empty()) {
    collect_study(study, all, folder);
    progress.say(fmt::format("written: {}/summary.md", output));
  }
  if (memory_limit_bytes() == 0) return;
  const auto lacks_memory = [&](const StudyRun& run) {
    return folder.result_of(run).status == RunStatus::out_of_memory;
  };
  if (const auto n = std::ranges::count_if(runs, lacks_memory); n > 0)
    throw MemoryError(fmt::format("{} of {} runs ended at {:g} MB, their share of it; all are in {}", n, runs.size(),
                                  study.options.limits.memory_mb, output));
}

}  // namespace shellmatch
