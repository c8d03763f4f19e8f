// `apply`: moves a mesh, a contour or points by the deformation of a run.

#include "apps/commands.h"
#include "apps/output_file.h"
#include "base/error.h"
#include "base/parallel.h"
#include "base/printable.h"
#include "geometry/io/read_shape.h"
#include "geometry/io/write_shape.h"
#include "matching/map_file/deformation_file.h"

#include <fmt/core.h>

#include <cstdio>

namespace shellmatch {

namespace {

OriginalShape<2> read(const std::string& path, std::vector<std::string>& notes, std::integral_constant<int, 2>) {
  return read_points_or_outline_2d(path, &notes);
}

OriginalShape<3> read(const std::string& path, std::vector<std::string>& notes, std::integral_constant<int, 3>) {
  return read_points_or_mesh_3d(path, &notes);
}

template <int Dim>
void apply(const ApplyCommand& command) {
  const Deformation<Dim> deformation = read_deformation<Dim>(command.deformation);
  std::vector<std::string> notes;
  OriginalShape<Dim> shape = read(command.file, notes, std::integral_constant<int, Dim>());
  for (const std::string& note : notes) std::fputs(fmt::format("{}\n", printable(note, max_message_length)).c_str(), stderr);

  std::size_t n_outside = 0;
  for (const Vec<Dim>& x : shape.vertices) {
    const Vec<Dim> y = deformation.to_unit_domain(x);
    n_outside += (y.array() < 0).any() || (y.array() > 1).any();
  }
  if (n_outside > 0)
    fmt::print(stderr, "{} of {} points lie outside the domain; they move with its nearest point\n", n_outside,
               shape.vertices.size());
  parallel_for(shape.vertices.size(), [&](std::size_t v) { shape.vertices[v] = deformation.apply(shape.vertices[v]); });
  write_output_file(command.output, shape);
}

}  // namespace

void execute(const ApplyCommand& command) {
  const int dimension = deformation_dimension(command.deformation);
  check_output_file(command.output, dimension, command.force);
  if (dimension == 2) apply<2>(command);
  else apply<3>(command);
}

}  // namespace shellmatch
