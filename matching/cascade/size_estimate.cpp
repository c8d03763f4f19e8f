#include "matching/cascade/size_estimate.h"

#include "base/error.h"
#include "matching/cascade/level_memory.h"
#include "matching/progress/process_info.h"

#include <algorithm>
#include <cmath>

namespace shellmatch {

namespace {

// Measured with Newton's method, whose matrix needs the most, and rounded up (docs/limits.md): fields, elements of the
// band, tables of the tree and vectors of the solver. At the start: the program with a shape and what pictures need.
constexpr double bytes_per_node = 800;
constexpr double bytes_at_start = 1e8;
constexpr double disk_bytes_per_node = 250;

// A shape's own grid is about twice as wide as the layer of cells that meet the shape. Memory: tree, distances and
// splines.
constexpr double field_layers = 2;
constexpr double bytes_per_field_node = 320;

// Of the estimated memory beyond that at the start, what a run needs at least: the numbers of nodes are estimated from
// above.
constexpr double least_share = 0.4;

bool fits(double needed, std::uint64_t given) { return given == 0 || needed <= static_cast<double>(given); }

template <int Dim>
double cells_at(double measure, int min_level, int max_level) {
  // A hyperplane in a random direction meets 4/pi (plane) or 3/2 (space) cells of side h per h^(Dim - 1). A refined
  // cell has 2^Dim children. The next coarser level has half as many cells along each direction of the surface. The 2:1
  // balance adds about one layer of cells on each side, except on the finest level.
  const double met = Dim == 2 ? 1.28 : 1.5, children = n_corners<Dim>;
  double cells = std::pow(children, min_level);
  for (int level = min_level + 1; level <= max_level; ++level) {
    const double parent_side = std::ldexp(1.0, 1 - level);
    const double parents = met * measure / std::pow(parent_side, Dim - 1);
    const double layers = level == max_level ? 1 : 3;
    cells += std::min(layers * parents, std::pow(children, level - 1)) * (children - 1);
  }
  return cells;
}

}  // namespace

template <int Dim>
RefinedMeasures refined_measures(const Surface<Dim>& reference, const Surface<Dim>& template_shape,
                                 const ExperimentOptions& options) {
  const double first = surface_measure(reference), both = first + surface_measure(template_shape);
  const bool smooth = options.coefficients.interpolation == FieldInterpolation::smooth;
  return {.phi = refines_at_template(options) ? both : first, .fields = smooth ? both : 0};
}

template <int Dim>
SizeEstimate estimate_size(const RefinedMeasures& measures, int min_level, int max_level) {
  constexpr double nodes_per_cell = Dim == 2 ? 1.3 : 1.45;
  SizeEstimate size;
  size.n_nodes = nodes_per_cell * cells_at<Dim>(measures.phi, min_level, max_level);
  if (measures.fields > 0)
    size.n_field_nodes = field_layers * nodes_per_cell * cells_at<Dim>(measures.fields, min_level, max_level);
  size.memory_bytes = bytes_at_start + bytes_per_node * size.n_nodes + bytes_per_field_node * size.n_field_nodes;
  size.disk_bytes = disk_bytes_per_node * size.n_nodes;
  return size;
}

template <int Dim>
void check_size(const RefinedMeasures& measures, int min_level, int max_level, const std::string& folder) {
  const std::uint64_t memory = available_memory_bytes(), disk = folder.empty() ? 0 : free_disk_bytes(folder);
  const SizeEstimate size = estimate_size<Dim>(measures, min_level, max_level);
  const double least =
      static_cast<double>(resident_memory_bytes()) + least_share * (size.memory_bytes - bytes_at_start);
  if (const auto limit = static_cast<double>(memory_limit_bytes()); limit > 0 && least > limit)
    throw LevelTooLarge(fmt::format("level {} would need at least {:.3g} GB of memory", max_level, least / 1e9));
  const bool memory_fits = fits(size.memory_bytes, memory);
  // Nodes and cells have 32-bit numbers.
  const bool countable = size.n_nodes < 1e9;
  if (memory_fits && countable && fits(size.disk_bytes, disk)) return;
  int largest = max_level - 1;
  while (largest > 1) {
    const SizeEstimate s = estimate_size<Dim>(measures, std::min(min_level, largest), largest);
    if (fits(s.memory_bytes, memory) && fits(s.disk_bytes, disk) && s.n_nodes < 1e9) break;
    --largest;
  }
  const bool lacks_disk = memory_fits && countable;
  const char* what = lacks_disk ? "room on the disk" : "memory";
  const double needed = lacks_disk ? size.disk_bytes : size.memory_bytes;
  const double given = static_cast<double>(lacks_disk ? disk : memory);
  const std::string text = fmt::format(
      "level {} needs about {:.3g} GB of {}, of which {:.3g} GB are free (estimated: {:.3g} million "
      "nodes); stop at level {} instead, with --levels {}:{}",
      max_level, needed / 1e9, what, given / 1e9, size.n_nodes / 1e6, largest, std::min(min_level, largest), largest);
  if (lacks_disk) throw DiskError(text);
  throw EnvironmentError(text);
}

SHELLMATCH_2D_3D(refined_measures);
SHELLMATCH_2D_3D(estimate_size);
SHELLMATCH_2D_3D(check_size);

}  // namespace shellmatch
