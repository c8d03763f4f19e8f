#include "apps/apply_volume.h"

#include "apps/output_file.h"
#include "apps/terminal/words.h"
#include "base/error.h"
#include "base/parallel.h"
#include "geometry/volume/sample_volume.h"
#include "geometry/volume/volume_file.h"
#include "geometry/volume/volume_name.h"
#include "matching/map_file/deformation_file.h"
#include "matching/map_file/user_map.h"

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace shellmatch {

namespace {

constexpr double least_determinant = 1e-6;  // whose logarithm is written where a map folds

Existing existing(const ApplyCommand& command) { return command.force ? Existing::is_replaced : Existing::is_kept; }

// Calls body(voxel, its centre in RAS) for all voxels.
void for_each_voxel(const VoxelGrid& grid, auto&& body) {
  const std::size_t n_lines = static_cast<std::size_t>(grid.size[1]) * grid.size[2];
  parallel_for(
      n_lines,
      [&](std::size_t line) {
        const int j = static_cast<int>(line % grid.size[1]), k = static_cast<int>(line / grid.size[1]);
        for (int i = 0; i < grid.size[0]; ++i) body(grid.number(i, j, k), grid.position(Vec<3>(i, j, k)));
      },
      16);
}

Sampling chosen_sampling(const ApplyCommand& command, const Volume& volume) {
  if (command.sampling == "nearest") return Sampling::nearest;
  if (command.sampling == "label") return Sampling::label;
  if (command.sampling == "linear") return Sampling::linear;
  if (!command.sampling.empty())
    throw_input_error("--sampling {}: expected nearest, label or linear", command.sampling);
  const bool is_label = is_label_volume(volume);
  say_line(fmt::format("{}: {}", command.file,
                       is_label
                           ? "whole numbers, of which few differ: carried as labels (--sampling linear for grey values)"
                           : "grey values: carried by linear interpolation (--sampling label for labels)"));
  return is_label ? Sampling::label : Sampling::linear;
}

void say_notes(const std::string& path, const std::vector<std::string>& notes) {
  for (const std::string& note : notes) say_line(fmt::format("{}: {}", path, note));
}

// The voxels of results; what their file leaves open is said.
VoxelGrid result_grid(const std::string& path) {
  VoxelGrid grid = read_voxel_grid(path);
  say_notes(path, volume_notes(grid));
  return grid;
}

PendingFile carried(const ApplyCommand& command, const Deformation<3>& deformation) {
  const Volume volume = read_volume(command.file);
  const VolumeSampler sampler(volume, chosen_sampling(command, volume));
  say_notes(command.file, volume_notes(volume.grid));
  Volume result{command.like.empty() ? volume.grid : result_grid(command.like), volume.type, {}};
  say_notes(command.output, written_notes(command.output, result.grid));
  result.values.assign(result.grid.n_voxels(), 0.0f);
  const UserMap<3> back(deformation, command.inverse ? Toward::template_shape : Toward::reference, command.keep_pose);
  std::atomic<std::size_t> n_inside{0};
  for_each_voxel(result.grid, [&](std::size_t voxel, const Vec<3>& x) {
    const auto from = back.within_domain(exchange_with_ras(deformation, x));
    if (!from) return;
    ++n_inside;
    result.values[voxel] = sampler(exchange_with_ras(deformation, *from), 0.0f);
  });
  if (n_inside == 0)
    throw_input_error("{}: none of its voxels lies where the map is defined: is it in the coordinates of the {}{}?",
                      command.like.empty() ? command.file : command.like, command.inverse ? "reference" : "template",
                      command.like.empty() ? "; --like gives the voxels of another volume" : "");
  return volume_file(command.output, result, existing(command));
}

// A field ends where its voxels do, the map does not.
void say_what_ends(const std::string& path, const VoxelGrid& grid, const std::vector<float>& values) {
  double largest = 0;
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i) {
        if (i % (grid.size[0] - 1) != 0 && j % (grid.size[1] - 1) != 0 && k % (grid.size[2] - 1) != 0) continue;
        const float* const u = &values[3 * grid.number(i, j, k)];
        largest = std::max(largest,
                           std::hypot(static_cast<double>(u[0]), static_cast<double>(u[1]), static_cast<double>(u[2])));
      }
  if (largest > 0.5 * grid.least_spacing())
    say_line(
        fmt::format("{}: ends at the border of its voxels, where it moves points by up to {:.3g}: ITK, ANTs and "
                    "elastix move nothing beyond; give --like a "
                    "volume that reaches further where that matters",
                    path, largest));
}

PendingFile displacement_file(const ApplyCommand& command, const Deformation<3>& deformation, const VoxelGrid& grid) {
  const UserMap<3> map(deformation, command.inverse ? Toward::reference : Toward::template_shape, command.keep_pose);
  std::vector<float> values(3 * grid.n_voxels(), 0.0f);
  std::atomic<std::size_t> n_lost{0};
  for_each_voxel(grid, [&](std::size_t voxel, const Vec<3>& x) {
    const auto y = map(exchange_with_ras(deformation, x));
    if (!y) {
      ++n_lost;
      return;
    }
    const Vec<3> displacement = exchange_space(Vec<3>(exchange_with_ras(deformation, *y) - x));
    for (int k = 0; k < 3; ++k) values[3 * voxel + static_cast<std::size_t>(k)] = static_cast<float>(displacement[k]);
  });
  if (n_lost > 0)
    say_line(fmt::format("{}: {} of {} voxels are the image of no point, and do not move", command.displacement,
                         n_lost.load(), grid.n_voxels()));
  say_what_ends(command.displacement, grid, values);
  return vector_volume_file(command.displacement, grid, values, existing(command));
}

PendingFile determinant_file(const ApplyCommand& command, const Deformation<3>& deformation, const VoxelGrid& grid,
                             const std::string& path, bool logarithm) {
  const UserMap<3> map(deformation, command.inverse ? Toward::reference : Toward::template_shape, command.keep_pose);
  Volume result{grid, VoxelType::float32, std::vector<float>(grid.n_voxels(), logarithm ? 0.0f : 1.0f)};
  std::atomic<std::size_t> n_folded{0};
  for_each_voxel(grid, [&](std::size_t voxel, const Vec<3>& x) {
    auto determinant = map.determinant(exchange_with_ras(deformation, x));
    if (!determinant) return;
    if (*determinant <= 0) ++n_folded;
    result.values[voxel] =
        static_cast<float>(logarithm ? std::log(std::max(*determinant, least_determinant)) : *determinant);
  });
  if (n_folded > 0)
    say_line(fmt::format("{}: the map is folded at {} of {} voxels", path, n_folded.load(), grid.n_voxels()));
  return volume_file(path, result, existing(command));
}

bool has_fields(const ApplyCommand& command) {
  return !command.displacement.empty() || !command.jacobian.empty() || !command.log_jacobian.empty();
}

}  // namespace

bool is_about_volumes(const ApplyCommand& command) {
  return has_fields(command) ||
         (!command.file.empty() && parse_volume_name(command.file) && parse_volume_name(command.output));
}

void apply_to_volumes(const ApplyCommand& command) {
  if (deformation_dimension(command.deformation) != 3)
    throw_input_error("{}: a map of the plane; volumes need one of space", command.deformation);
  const bool carries = !command.file.empty();
  if (carries && !is_volume_file(command.file) && parse_volume_name(command.file))
    throw_input_error(
        "{}: a volume is carried as a whole; name the file alone, or write a mesh of the labels (-o moved.ply)",
        command.file);
  if (carries && !is_volume_file(command.file))
    throw_input_error(
        "{}: fields of the map are written without a file to move; give --like the volume whose voxels they are to "
        "have, and move this in a "
        "command of its own",
        command.file);
  std::set<std::filesystem::path> outputs;
  for (const std::string& output : {command.output, command.displacement, command.jacobian, command.log_jacobian})
    if (!output.empty()) {
      check_volume_output(output);
      check_report_file(output, command.force);
      if (!outputs.insert(std::filesystem::weakly_canonical(output)).second)
        throw_input_error("{}: is named for two results; give each a file of its own", output);
    }
  if (!carries && !command.sampling.empty())
    throw_input_error("apply: --sampling {} is for a volume that is carried, and there is none", command.sampling);
  if (has_fields(command) && command.like.empty() && !carries)
    throw_input_error("apply: say on which voxels: --like VOLUME");
  const Deformation<3> deformation = read_deformation<3>(command.deformation);
  if (deformation.bend)
    throw_input_error(
        "{}: its run has bent the surface of the reference first, so that it is a map of the surface: it moves meshes "
        "and points on it, no volumes and no fields; match again with --set align.bend=never",
        command.deformation);
  std::vector<PendingFile> results;
  if (carries) results.push_back(carried(command, deformation));
  if (has_fields(command)) {
    const std::string& like = command.like.empty() ? command.file : command.like;
    const VoxelGrid grid = carries ? read_voxel_grid(like) : result_grid(like);
    for (const std::string& path : {command.displacement, command.jacobian, command.log_jacobian})
      if (!path.empty()) say_notes(path, written_notes(path, grid));
    if (!command.displacement.empty()) results.push_back(displacement_file(command, deformation, grid));
    if (!command.jacobian.empty())
      results.push_back(determinant_file(command, deformation, grid, command.jacobian, false));
    if (!command.log_jacobian.empty())
      results.push_back(determinant_file(command, deformation, grid, command.log_jacobian, true));
  }
  publish_together(results);
}

}  // namespace shellmatch
