#include "geometry/label/volume_shape.h"

#include "base/error.h"
#include "base/parallel.h"
#include "base/text.h"
#include "geometry/distance/buried_parts.h"
#include "geometry/distance/surface_distance.h"
#include "geometry/implicit/mesh_implicit.h"
#include "geometry/label/label_region.h"
#include "geometry/label/smoothed_label.h"
#include "geometry/label/surface_parts.h"
#include "geometry/repair/make_shape.h"
#include "geometry/surface/surface.h"
#include "geometry/volume/grid_file.h"
#include "geometry/volume/volume_file.h"

#include <Eigen/LU>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace shellmatch {

namespace {

// Whether a voxel next to `index` in the layer `at` across the axis is chosen.
bool is_cut(const Volume& volume, const VoxelChoice& choice, int axis, int at, const Vec<3>& index,
            const std::array<int, 3>& blocks) {
  std::array<int, 3> low, high;
  for (int a = 0; a < 3; ++a) {
    const int last = volume.grid.size[a] - 1;
    low[a] =
        a == axis ? at : static_cast<int>(std::clamp(std::floor(index[a] - blocks[a]), 0.0, static_cast<double>(last)));
    high[a] =
        a == axis ? at : static_cast<int>(std::clamp(std::ceil(index[a] + blocks[a]), 0.0, static_cast<double>(last)));
  }
  for (int k = low[2]; k <= high[2]; ++k)
    for (int j = low[1]; j <= high[1]; ++j)
      for (int i = low[0]; i <= high[0]; ++i)
        if (choice.contains(volume.values[volume.grid.number(i, j, k)])) return true;
  return false;
}

// The facets, ascending, that lie within one voxel (of a label in blocks: one block) of the border of the volume
// beside chosen voxels at it. Smoothing rounds the edge of the cut, which reaches no deeper. \param surface of the
// label, in RAS \param volume canonical(), of which `region` was made
std::vector<Index> facets_at_border(const Surface<3>& surface, const Volume& volume, const VoxelChoice& choice,
                                    const LabelRegion& region) {
  const VoxelGrid& grid = volume.grid;
  const Mat<3> to_index = grid.axes.inverse();
  std::array<int, 3> blocks;
  for (int a = 0; a < 3; ++a)
    blocks[a] = static_cast<int>(std::lround(region.grid.axes.col(a).norm() / grid.axes.col(a).norm()));
  std::vector<Index> found;
  for (std::size_t f = 0; f < surface.facets.size(); ++f) {
    const auto& [a, b, c] = surface.facets[f];
    const Vec<3> centre = (surface.vertices[a] + surface.vertices[b] + surface.vertices[c]) / 3;
    const Vec<3> index = to_index * (centre - grid.origin);
    for (int axis = 0; axis < 3; ++axis) {
      const double depth = blocks[axis] - 0.5;  // the border is half a voxel before the first
      const int last = grid.size[axis] - 1;
      if ((index[axis] < depth && is_cut(volume, choice, axis, 0, index, blocks)) ||
          (index[axis] > last - depth && is_cut(volume, choice, axis, last, index, blocks))) {
        found.push_back(static_cast<Index>(f));
        break;
      }
    }
  }
  return found;
}

// The label as a function on the unit cube, which the mesher for implicit functions wants.
class LabelFunction {
 public:
  LabelFunction(const LabelRegion& region, const SmoothedLabel& label) : grid_(region.grid), label_(&label) {
    Box<3> box;
    for (int c = 0; c < 8; ++c) {
      Vec<3> corner;
      for (int a = 0; a < 3; ++a) corner[a] = c >> a & 1 ? grid_.size[a] - region_margin : region_margin - 1;
      box.add(grid_.position(corner));
    }
    extent_ = (box.max - box.min).maxCoeff();
    scale_ = 0.88 / extent_;
    centre_ = 0.5 * (box.min + box.max);
    to_index_ = grid_.axes.inverse();
    const double spacing = scale_ * grid_.least_spacing();
    gain_ = 1.8 / steepest * spacing;
    reach_ = 2 * spacing;
  }

  Vec<3> point(const Vec<3>& unit) const { return centre_ + (unit - Vec<3>::Constant(0.5)) / scale_; }
  double extent() const { return extent_; }
  double to_unit(double length) const { return length * scale_; }

  // Negative inside, Lipschitz with the constant 2 where it matters: far from the surface it says how far that is at
  // least.
  double operator()(const Vec<3>& unit) const {
    const Vec<3> index = to_index_ * (point(unit) - grid_.origin);
    const double value = gain_ * (label_->level() - label_->share(index));
    return std::copysign(std::max(std::abs(value), reach_ * label_->clearance(index)), value);
  }

 private:
  // The slope of a share across a plane of voxels, per voxel.
  static constexpr double steepest = 0.625;

  VoxelGrid grid_;
  const SmoothedLabel* label_;
  Mat<3> to_index_;
  Vec<3> centre_;
  double extent_, scale_, gain_, reach_;
};

Surface<3> mesh(const LabelFunction& function, const LabelRegion& region, const std::string& source) {
  // Finer triangles show no more of the voxels, and a label of the largest size gets as many as a grid of level 7 can
  // use.
  const double edge = std::max(0.7 * region.grid.least_spacing(), function.extent() / most_voxels_across);
  const ImplicitFunction f = [&](const Vec<3>& x) { return function(x); };
  Surface<3> surface = mesh_implicit(f, function.to_unit(edge), source, Details::as_they_come);
  for (Vec<3>& x : surface.vertices) x = function.point(x);
  return surface;
}

// Distances of the surface to the middles of faces between voxels inside and outside.
DistanceStatistics distance_to_voxels(const LabelRegion& region, const Surface<3>& surface) {
  const VoxelGrid& grid = region.grid;
  std::vector<Vec<3>> faces;
  for (int k = 0; k + 1 < grid.size[2]; ++k)
    for (int j = 0; j + 1 < grid.size[1]; ++j)
      for (int i = 0; i + 1 < grid.size[0]; ++i)
        for (int a = 0; a < 3; ++a) {
          const bool here = region.shares[grid.number(i, j, k)] > 0.5f,
                     there = region.shares[grid.number(i + (a == 0), j + (a == 1), k + (a == 2))] > 0.5f;
          if (here != there) faces.push_back(grid.position(Vec<3>(i, j, k) + 0.5 * Vec<3>::Unit(a)));
        }
  constexpr std::size_t enough = 20000;
  std::vector<Vec<3>> some;
  const std::size_t stride = faces.size() / enough + 1;
  for (std::size_t n = 0; n < faces.size(); n += stride) some.push_back(faces[n]);
  return statistics(distances_to(some, surface));
}

// What became of the voxels, and a warning where that is not much.
std::vector<std::string> result_notes(const VoxelChoice& choice, const LabelRegion& region, const Surface<3>& surface) {
  constexpr double enough = 0.8;
  const double voxels = std::accumulate(region.shares.begin(), region.shares.end(), 0.0);
  const double share = enclosed_measure(surface) / (voxels * region.grid.voxel_volume());
  std::string text = fmt::format("{}: {:.0f} voxels of {}; smoothed by {} of a voxel, the surface ", choice.text(),
                                 voxels, spacing_text(region.grid), label_smoothing);
  // Where no block of voxels is more than half full, nothing says where the boundary is.
  if (const DistanceStatistics d = distance_to_voxels(region, surface); std::isfinite(d.mean))
    text += fmt::format(
        "is {:.2g} from the voxels' boundary on average and at most {:.2g}, and its volume {:.2f} times theirs", d.mean,
        d.max, share);
  else text += fmt::format("has {:.2f} times their volume", share);
  std::vector<std::string> notes{text};
  if (share < enough)
    notes.push_back(fmt::format(
        "the surface has only {:.0f} % of the label's volume: the rest is thinner than its voxels (or blocks of "
        "these) can show, and is lost; cut the volume to the region of interest, or sample it more finely",
        100 * share));
  return notes;
}

// What closes the surface at the border of the volume is no evidence, unless there is hardly anything else.
void leave_out_border(const Volume& volume, const VoxelChoice& choice, const LabelRegion& region, Shape<3>& shape) {
  constexpr double most = 0.9;
  Surface<3> in_ras = shape.surface;
  change_space(in_ras.vertices, shape.original.space, Space::ras);
  const std::vector<Index> facets = facets_at_border(in_ras, volume, choice, region);
  double area = 0;
  for (const Index f : facets) area += facet_measure(shape.surface, f);
  const double share = area / surface_measure(shape.surface);
  const std::string text = fmt::format("it reaches the border of the volume ({}) and is closed there",
                                       counted(region.n_at_border, "voxel", "voxels"));
  if (share > most) {
    shape.notes.push_back(fmt::format(
        "{}, which is {:.2g} % of the area: hardly anything else is seen of it, and that part counts as its surface",
        text, 100 * share));
    return;
  }
  shape.evidence = without_buried(shape.surface, shape.evidence, facets);
  shape.invented_share = share;
  shape.notes.push_back(
      fmt::format("{}: that part, {:.2g} % of the area, is made up, and weighs nothing", text, 100 * share));
}

}  // namespace

Shape<3> volume_shape(const VolumeName& name, const std::string& source, Space space) {
  return volume_shape(read_volume_part(name), source, space);
}

Shape<3> volume_shape(VolumePart part, const std::string& source, Space space) {
  const VoxelGrid grid = part.volume.grid;
  Volume volume = canonical(std::move(part.volume));
  LabelRegion region = label_region(volume, part.choice, source);
  if (region.n_at_border == 0) volume = {};  // it is large, and no longer needed
  const SmoothedLabel label(region);
  if (!(label.largest_share() > label.level() + 1e-3))
    throw_input_error(
        "{}: {} is too small or too thin for a surface: nothing is left of it where its stairs are smoothed", source,
        part.choice.text());
  Surface<3> surface = mesh(LabelFunction(region, label), region, source);
  std::vector<std::string> notes = std::move(region.notes);
  const double voxel = region.grid.voxel_volume();
  if (const std::size_t n = drop_small_parts(surface, 4 * voxel); n > 0)
    notes.push_back(fmt::format("{} of less than 4 voxels, which smoothing left of thin parts, dropped",
                                counted(n, "piece", "pieces")));
  if (surface.facets.empty())
    throw_input_error("{}: {} is too small or too thin for a surface", source, part.choice.text());
  const std::vector<std::string> result = result_notes(part.choice, region, surface);
  notes.insert(notes.begin(), result.begin(), result.end());
  if (grid.file)
    notes.push_back(fmt::format("its voxels are placed by {}; the surface is in {}", grid.file->placed_by,
                                space_name(or_default(space))));
  for (const std::string& note : volume_notes(grid)) notes.push_back(note);
  OriginalShape<3> original;
  original.vertices = std::move(surface.vertices);
  original.space = or_default(space);
  change_space(original.vertices, Space::ras, original.space);
  for (const auto& [a, b, c] : surface.facets) original.polygons.push_back({a, b, c});
  Shape<3> shape = make_shape(std::move(original), source, std::move(notes));
  shape.unit = grid.unit;
  if (region.n_at_border > 0) leave_out_border(volume, part.choice, region, shape);
  return shape;
}

}  // namespace shellmatch
