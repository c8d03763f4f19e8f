// `apply`: moves a mesh, a contour or points by the deformation of a run.

#include "apps/apply_volume.h"
#include "apps/commands.h"
#include "apps/process/interrupt.h"
#include "apps/output_file.h"
#include "base/error.h"
#include "base/parallel.h"
#include "base/printable.h"
#include "geometry/io/read_shape.h"
#include "geometry/io/write_shape.h"
#include "geometry/label/volume_shape.h"
#include "matching/map_file/deformation_file.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

namespace shellmatch {

namespace {

OriginalShape<2> read(const std::string& path, std::vector<std::string>& notes, Space, std::integral_constant<int, 2>) {
  return read_points_or_outline_2d(path, &notes);
}

OriginalShape<3> read(const std::string& path, std::vector<std::string>& notes, Space space, std::integral_constant<int, 3>) {
  if (const auto volume = parse_volume_name(path)) {
    Shape<3> shape = volume_shape(*volume, path, space);
    notes = std::move(shape.notes);
    return std::move(shape.original);
  }
  return read_points_or_mesh_3d(path, &notes);
}

template <int Dim>
void move(const Deformation<Dim>& deformation, std::vector<Vec<Dim>>& points) {
  std::size_t n_outside = 0;
  for (const Vec<Dim>& x : points) {
    const Vec<Dim> y = deformation.to_unit_domain(x);
    n_outside += (y.array() < 0).any() || (y.array() > 1).any();
  }
  if (n_outside > 0)
    fmt::print(stderr, "{} of {} points lie outside the domain; they move with its nearest point\n", n_outside, points.size());
  parallel_for(points.size(), [&](std::size_t v) { points[v] = deformation.apply(points[v]); });
}

template <int Dim>
void move_back(const PointMap<Dim>& map, const std::string& file, std::vector<Vec<Dim>>& points) {
  std::vector<char> is_lost(points.size());
  parallel_for(points.size(), [&](std::size_t v) {
    if (const auto x = map(points[v])) points[v] = *x;
    else is_lost[v] = 1;
  });
  const auto first = std::find(is_lost.begin(), is_lost.end(), 1);
  if (first != is_lost.end())
    throw_input_error("{}: {} of {} points are the image of none, the first of them {}, counted from 0: they lie beyond what the deformed domain covers; "
                      "leave them out", file, std::count(first, is_lost.end(), 1), points.size(), first - is_lost.begin());
}

template <int Dim>
void apply(const ApplyCommand& command) {
  const Deformation<Dim> deformation = read_deformation<Dim>(command.deformation);
  std::vector<std::string> notes;
  OriginalShape<Dim> shape = read(command.file, notes, deformation.space, std::integral_constant<int, Dim>());
  for (const std::string& note : notes) std::fputs(fmt::format("{}\n", printable(note, max_message_length)).c_str(), stderr);

  if (command.keep_pose && deformation.pose.is_identity())
    std::fputs("no motion was taken out before this matching: --keep-pose changes nothing\n", stderr);
  if (command.keep_pose && command.inverse)
    for (Vec<Dim>& x : shape.vertices) x = deformation.from_reference_pose(x);
  const PointMap<Dim> map(deformation, command.inverse ? Toward::reference : Toward::template_shape);
  if (map.is_inverse()) move_back(map, command.file, shape.vertices);
  else move(deformation, shape.vertices);
  if (command.keep_pose && !command.inverse)
    for (Vec<Dim>& x : shape.vertices) x = deformation.to_reference_pose(x);
  write_output_file(command.output, shape, command.force);
}

}  // namespace

void execute(const ApplyCommand& command) {
  catch_interrupts();
  if (is_about_volumes(command)) return apply_to_volumes(command);
  if (!command.like.empty() || !command.sampling.empty())
    throw_input_error("apply: --like and --sampling are for volumes: give a volume, as {}, to move, and one to write (-o)", volume_endings);
  const int dimension = deformation_dimension(command.deformation);
  check_output_file(command.output, dimension, command.force);
  if (dimension == 2) apply<2>(command);
  else apply<3>(command);
}

}  // namespace shellmatch
