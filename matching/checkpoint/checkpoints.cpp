#include "matching/checkpoint/checkpoints.h"

#include "base/error.h"
#include "matching/checkpoint/alignment_file.h"
#include "matching/checkpoint/level_vertices.h"
#include "matching/output/checksum.h"
#include "matching/map_file/deformation_file.h"
#include "matching/experiment/option_text.h"
#include "matching/output/hidden_names.h"
#include "matching/output/leftovers.h"
#include "matching/output/output_folder.h"
#include "matching/progress/process_info.h"
#include "matching/output/write_file.h"
#include "matching/output/written_files.h"
#include "matching/experiment/yaml_options.h"

#include <dlfcn.h>

#include <filesystem>

namespace shellmatch {

namespace fs = std::filesystem;

namespace {

constexpr const char* manifest_name = "state.json";
constexpr const char* suffix = ".unfinished";

constexpr const char* read_me =
    R"(An unfinished run of shellmatch: what is needed to go on after its alignment or its last finished level.

The same command as before goes on from here and removes this folder when it is done; with --restart it begins anew.
After a level the map reached so far is in deformation.vtu: `shellmatch apply THIS_FOLDER SHAPE -o MOVED` moves a shape
by it.
To give the run up, delete this folder.
)";

template <class T>
std::string_view bytes_of(const std::vector<T>& values) {
  static_assert(std::is_same_v<T, Vec<2>> || std::is_same_v<T, Vec<3>> || std::is_trivially_copyable_v<T>);
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

template <int Dim>
std::string shape_checksum(const OriginalShape<Dim>& shape) {
  Checksum sum;
  sum.add(bytes_of(shape.vertices));
  for (const std::vector<Index>& polygon : shape.polygons) {
    const auto n = static_cast<std::uint64_t>(polygon.size());
    sum.add({reinterpret_cast<const char*>(&n), sizeof n}).add(bytes_of(polygon));
  }
  return sum.text();
}

template <int Dim>
std::string landmark_checksum(const std::vector<Landmark<Dim>>& landmarks) {
  if (landmarks.empty()) return "";
  std::vector<Vec<Dim>> points;
  std::vector<double> weights;
  for (const Landmark<Dim>& landmark : landmarks) {
    points.push_back(landmark.on_reference);
    points.push_back(landmark.on_template);
    weights.push_back(landmark.weight);
  }
  return Checksum().add(bytes_of(points)).add(bytes_of(weights)).text();
}

// Shapes and landmarks are compared by checksums of their contents; true positions are read only for the final report.
bool changes_no_level(const std::string& option) {
  for (const char* path : {"input.reference", "input.template", "input.correspondence", "landmarks.file",
                           "landmarks.template_file", "report", "threads"})
    if (option == path) return true;
  return option.starts_with("resume.");
}

std::string first_change(const OptionNode& before, const OptionNode& now) {
  const auto text = [](const OptionNode& section, const OptionNode& option) {
    return option.level_overrides != nullptr ? level_overrides_text(section, *option.level_overrides)
                                             : value_text(option);
  };
  for (std::size_t i = 0; i < now.children.size(); ++i) {
    const OptionNode &a = before.children[i], &b = now.children[i];
    if (b.kind == OptionKind::section) {
      if (std::string change = first_change(a, b); !change.empty()) return change;
    } else if (!changes_no_level(b.path)) {
      if (const std::string was = text(before, a), is = text(now, b); was != is)
        return fmt::format("{}: {}, now {}", b.path, was, is);
    }
  }
  return "";
}

// Of the file that holds this code: the executable, or the library that a package's executable or Python has loaded.
std::string code_checksum() {
  std::string file = "/proc/self/exe";
  Dl_info info{};
  // Of the executable the name is the one that it was called by, perhaps in another folder.
  if (::dladdr(reinterpret_cast<const void*>(&changed_option), &info) != 0 && info.dli_fname != nullptr &&
      fs::path(info.dli_fname).filename().string().find(".so") != std::string::npos)
    file = info.dli_fname;
  try {
    return file_checksum(file);
  } catch (const InputError&) {  // a program may be allowed to be executed and not to be read
    return "unknown";
  }
}

[[noreturn]] void cannot_copy(const std::string& to, const std::error_code& error) {
  cannot_be_written(error.value(), fmt::format("{}: cannot be written: {}", to, error.message()));
}

// Copies all files of `from`; does nothing where there is no such folder.
void copy_files(const fs::path& from, const fs::path& to) {
  std::error_code error;
  if (!fs::is_directory(from, error)) return;
  fs::create_directories(to, error);
  if (error) cannot_copy(to.string(), error);
  for (const fs::directory_entry& entry : fs::directory_iterator(from, error)) {
    fs::copy_file(entry.path(), to / entry.path().filename(), fs::copy_options::overwrite_existing, error);
    if (error) cannot_copy((to / entry.path().filename()).string(), error);
  }
}

}  // namespace

template <int Dim>
RunIdentity run_identity(const ExperimentOptions& options, const OriginalShape<Dim>& reference,
                         const OriginalShape<Dim>& template_shape, const std::vector<Landmark<Dim>>& landmarks) {
  return {with_absolute_paths(options), shape_checksum(reference), shape_checksum(template_shape),
          landmark_checksum(landmarks), fmt::format("{}, {}, {}", program_version(), compiler_name(), code_checksum())};
}

std::string changed_option(const ExperimentOptions& before, const ExperimentOptions& now) {
  ExperimentOptions a = before, b = now;
  return first_change(option_tree(a), option_tree(b));
}

CheckpointFolder::CheckpointFolder(const std::string& output, RunIdentity identity)
    : path_(output + suffix), identity_(std::move(identity)) {
  remove_leftovers(path_);
}

bool CheckpointFolder::is_ours() const {
  std::error_code error;
  return fs::is_regular_file(fs::path(path_) / manifest_name, error);
}

bool CheckpointFolder::is_foreign() const {
  std::error_code error;
  return fs::exists(path_, error) && !is_ours();
}

std::string CheckpointFolder::obstacle() const {
  if (!is_ours()) return "";
  const fs::path folder = path_;
  const auto manifest = read_manifest(folder / manifest_name);
  if (!manifest) return fmt::format("its {} is damaged", manifest_name);
  constexpr const char* other_program = "another build of the program has written it";
  if (manifest->format != CheckpointManifest().format) return other_program;
  try {
    const auto files = read_file_list(path_);
    if (!files) return fmt::format("its {} is damaged", written_files_name);
    for (const WrittenFile& file : *files)
      if (file_checksum(folder / file.name) != file.checksum) return fmt::format("its {} is damaged", file.name);
    if (manifest->program != identity_.program) return other_program;
    const std::string change = changed_option(read_experiment(folder / "config.yaml"), identity_.options);
    if (!change.empty()) return fmt::format("the configuration has changed ({})", change);
  } catch (const InputError& damage) {
    return fmt::format("it is damaged ({})", damage.what());
  }
  if (manifest->reference != identity_.reference) return "the reference is another one";
  if (manifest->template_shape != identity_.template_shape) return "the template is another one";
  if (manifest->landmarks.value_or("") != identity_.landmarks) return "the landmarks are others";
  return "";
}

int CheckpointFolder::level() const {
  const std::optional<CheckpointManifest> manifest = read_manifest(fs::path(path_) / manifest_name);
  return manifest ? manifest->level : 0;
}

template <int Dim>
AlignmentFindings<Dim> CheckpointFolder::read_alignment() const {
  if (!is_ours()) return {};
  return shellmatch::read_alignment<Dim>(fs::path(path_) / alignment_file_name);
}

template <int Dim>
std::optional<MatchProgress<Dim>> CheckpointFolder::read(std::size_t n_vertices) const {
  if (!is_ours() || level() == 0) return std::nullopt;
  const fs::path folder = path_;
  return MatchProgress<Dim>{read_deformation<Dim>(folder), read_history(folder / "history.csv"),
                            read_summary(folder / "summary.json"),
                            read_level_vertices<Dim>(folder / level_vertices_file_name, n_vertices)};
}

template <int Dim>
void CheckpointFolder::write(const CheckpointView<Dim>& checkpoint, const std::string& pictures) {
  OutputFolder folder(path_, true, ChangedFiles::are_written);  // a damaged checkpoint may be replaced
  write_deformation(folder.path_of(deformation_file_name), checkpoint.grid, checkpoint.phi, checkpoint.frame);
  write_history(checkpoint.history, folder.path_of("history.csv"));
  write_summary(checkpoint.summary, folder.path_of("summary.json"));
  write_level_vertices<Dim>(checkpoint.levels, folder.path_of(level_vertices_file_name));
  write_alignment(checkpoint.findings, folder.path_of(alignment_file_name));
  copy_files(pictures, folder.path_of("pictures"));
  write_rest(folder, checkpoint.summary.levels.back().level);
}

template <int Dim>
void CheckpointFolder::write(const AlignmentFindings<Dim>& findings) {
  OutputFolder folder(path_, true, ChangedFiles::are_written);
  write_alignment(findings, folder.path_of(alignment_file_name));
  write_rest(folder, 0);
}

void CheckpointFolder::write_rest(OutputFolder& folder, int level) const {
  write_file(folder.path_of("config.yaml"), to_yaml(identity_.options));
  write_file(folder.path_of("README.txt"), read_me);
  CheckpointManifest manifest;
  manifest.level = level;
  manifest.program = identity_.program;
  manifest.reference = identity_.reference;
  manifest.template_shape = identity_.template_shape;
  if (!identity_.landmarks.empty()) manifest.landmarks = identity_.landmarks;
  write_file(folder.path_of(manifest_name), manifest_json(manifest));
  folder.commit();
}

void CheckpointFolder::copy_pictures(const std::string& pictures) const {
  for (const WrittenFile& file : read_file_list(path_).value_or(std::vector<WrittenFile>{})) {
    const fs::path name = file.name;
    if (name.parent_path() != "pictures") continue;
    std::error_code error;
    fs::create_directories(pictures, error);
    fs::copy_file(fs::path(path_) / name, fs::path(pictures) / name.filename(), fs::copy_options::overwrite_existing,
                  error);
    if (error) cannot_copy((fs::path(pictures) / name.filename()).string(), error);
  }
}

void CheckpointFolder::remove() {
  if (!is_ours()) return;
  std::error_code error;
  if (!foreign_text().empty()) {
    if (!read_file_list(path_)) return;
    fs::remove(fs::path(path_) / manifest_name, error);  // first, so that a kill leaves no half of a checkpoint
    return remove_written_files(path_);
  }
  // Renamed first to a name that the next run cleans up, so that a kill leaves no half-removed checkpoint.
  const std::string hidden = partial_folder_name(path_);
  fs::rename(path_, hidden, error);
  if (error) return;
  remove_written_files(hidden);
  if (first_foreign_thing(hidden, ChangedFiles::are_written)) fs::rename(hidden, path_, error);  // it came in meanwhile
}

std::string CheckpointFolder::foreign_text() const {
  if (!is_ours()) return "";
  const ForeignThing thing = first_foreign_thing(path_, ChangedFiles::are_written);
  return thing ? shellmatch::foreign_text(thing) : "";
}

SHELLMATCH_2D_3D(run_identity);
#define SHELLMATCH_INSTANTIATE(Dim)                                                          \
  template AlignmentFindings<Dim> CheckpointFolder::read_alignment<Dim>() const;             \
  template std::optional<MatchProgress<Dim>> CheckpointFolder::read<Dim>(std::size_t) const; \
  template void CheckpointFolder::write<Dim>(const AlignmentFindings<Dim>&);                 \
  template void CheckpointFolder::write<Dim>(const CheckpointView<Dim>&, const std::string&);
SHELLMATCH_INSTANTIATE(2)
SHELLMATCH_INSTANTIATE(3)
#undef SHELLMATCH_INSTANTIATE

}  // namespace shellmatch
