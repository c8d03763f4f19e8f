#include "geometry/label/label_region.h"

#include "base/error.h"
#include "base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <set>
#include <vector>

namespace shellmatch {

namespace {

struct Removed {
  std::size_t n_components = 0, n_voxels = 0;
};

// Gives all voxels of value `from` in components of fewer than `least` voxels the value `to`. \param diagonal voxels
// are neighbours across edges and corners, too, and not across faces alone \param keep_largest the largest component
// stays in any case \return how many components and voxels that were
Removed remove_small_components(const std::array<int, 3>& size, std::uint8_t from, std::uint8_t to, std::size_t least,
                                bool diagonal, bool keep_largest, std::vector<std::uint8_t>& voxels) {
  std::vector<char> is_seen(voxels.size(), 0);
  std::vector<std::vector<std::size_t>> small;
  std::vector<std::size_t> component;
  std::size_t largest = 0;
  for (std::size_t seed = 0; seed < voxels.size(); ++seed) {
    if (is_seen[seed] || voxels[seed] != from) continue;
    component.assign(1, seed);
    is_seen[seed] = 1;
    for (std::size_t next = 0; next < component.size(); ++next) {
      const std::size_t at = component[next];
      const int i = static_cast<int>(at % size[0]), j = static_cast<int>(at / size[0] % size[1]),
                k = static_cast<int>(at / (static_cast<std::size_t>(size[0]) * size[1]));
      for (int dk = -1; dk <= 1; ++dk)
        for (int dj = -1; dj <= 1; ++dj)
          for (int di = -1; di <= 1; ++di) {
            if (!diagonal && std::abs(di) + std::abs(dj) + std::abs(dk) != 1) continue;
            if (i + di < 0 || i + di >= size[0] || j + dj < 0 || j + dj >= size[1] || k + dk < 0 || k + dk >= size[2])
              continue;
            const std::size_t neighbour = (static_cast<std::size_t>(k + dk) * size[1] + (j + dj)) * size[0] + (i + di);
            if (is_seen[neighbour] || voxels[neighbour] != from) continue;
            is_seen[neighbour] = 1;
            component.push_back(neighbour);
          }
    }
    largest = std::max(largest, component.size());
    if (component.size() < least) small.push_back(component);
  }
  Removed removed;
  for (const std::vector<std::size_t>& each : small) {
    if (keep_largest && each.size() == largest) {
      keep_largest = false;  // of several as large, the first
      continue;
    }
    ++removed.n_components;
    removed.n_voxels += each.size();
    for (const std::size_t v : each) voxels[v] = to;
  }
  return removed;
}

constexpr std::size_t least_label = 8;  // voxels

// The values that there are, but for 0; none where they are not those of labels.
std::set<float> labels_of(const Volume& volume) {
  constexpr std::size_t most = 1000;
  std::set<float> labels;
  float last = 0;
  for (const float v : volume.values) {
    if (v == 0 || v == last) continue;
    last = v;
    if (v != std::round(v) || (labels.insert(v), labels.size() > most)) return {};
  }
  return labels;
}

std::string list_text(const std::set<float>& labels) {
  std::string text;
  std::size_t n = 0;
  for (const float label : labels) {
    if (++n > 20) return text + fmt::format(" and {} more", labels.size() - 20);
    text += fmt::format("{}{:g}", n == 1 ? "" : ", ", label);
  }
  return text;
}

void check_choice(const Volume& volume, const VoxelChoice& choice, std::size_t n_chosen, const std::string& source) {
  const auto [least, most] = std::minmax_element(volume.values.begin(), volume.values.end());
  if (!choice.labels.empty()) {
    const std::set<float> there = labels_of(volume);
    std::set<float> absent;
    for (const double label : choice.labels)
      if (std::ranges::find(volume.values, static_cast<float>(label)) == volume.values.end())
        absent.insert(static_cast<float>(label));
    if (!absent.empty())
      throw_input_error(
          "{}: no voxel has the label {}; {}", source, list_text(absent),
          !there.empty() ? "there are the labels " + list_text(there)
          : *least == *most
              ? fmt::format("all voxels are {:g}", *least)
              : fmt::format(
                    "its values are from {:g} to {:g} and no labels: choose a threshold, as in \"scan.nii.gz:>0.5\"",
                    *least, *most));
  }
  if (n_chosen == 0)
    throw_input_error("{}: no voxel is above {:g}: its values are from {:g} to {:g}", source, choice.above, *least,
                      *most);
  if (n_chosen == volume.values.size())
    throw_input_error(
        "{}: every voxel is in the shape ({}): its values are from {:g} to {:g}; choose a label or a threshold, as in "
        "\"scan.nii.gz:3\" or "
        "\"scan.nii.gz:>0.5\"",
        source, choice.text(), *least, *most);
}

struct IndexBox {
  std::array<int, 3> low{1 << 30, 1 << 30, 1 << 30}, high{-1, -1, -1};
  void add(const std::array<int, 3>& index) {
    for (std::size_t a = 0; a < 3; ++a) {
      low[a] = std::min(low[a], index[a]);
      high[a] = std::max(high[a], index[a]);
    }
  }
};

// The box of the chosen voxels, and how many of them are at the border of the volume.
struct Chosen {
  IndexBox box;
  std::size_t n = 0, n_at_border = 0;
};

Chosen find_chosen(const Volume& volume, const VoxelChoice& choice) {
  const auto& size = volume.grid.size;
  Chosen chosen;
  std::size_t at = 0;
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i, ++at) {
        if (!choice.contains(volume.values[at])) continue;
        const std::array<int, 3> index{i, j, k};
        bool is_at_border = false;
        for (std::size_t a = 0; a < 3; ++a) is_at_border = is_at_border || index[a] == 0 || index[a] == size[a] - 1;
        chosen.box.add(index);
        ++chosen.n;
        chosen.n_at_border += is_at_border;
      }
  return chosen;
}

// How many voxels along each axis become one, so that none of them is much finer than a 160th of the label's extent.
std::array<int, 3> block_sides(const VoxelGrid& grid, const IndexBox& box) {
  const Vec<3> spacing = grid.axes.colwise().norm();
  double extent = 0;
  for (int a = 0; a < 3; ++a) extent = std::max(extent, (box.high[a] - box.low[a] + 1) * spacing[a]);
  std::array<int, 3> sides;
  for (int a = 0; a < 3; ++a)
    sides[a] = static_cast<int>(std::clamp(std::ceil(extent / most_voxels_across / spacing[a] - 1e-9), 1.0,
                                           static_cast<double>(box.high[a] - box.low[a] + 1)));
  return sides;
}

}  // namespace

LabelRegion label_region(const Volume& volume, const VoxelChoice& choice, const std::string& source) {
  const Chosen chosen = find_chosen(volume, choice);
  check_choice(volume, choice, chosen.n, source);
  const auto& [low, high] = chosen.box;
  if (chosen.n < least_label)
    throw_input_error("{}: {} has {}: too small for a surface", source, choice.text(),
                      counted(chosen.n, "voxel", "voxels"));
  LabelRegion region;
  region.n_at_border = chosen.n_at_border;

  // One free voxel all around, so that the outside is connected.
  std::array<int, 3> size;
  for (std::size_t a = 0; a < 3; ++a) size[a] = high[a] - low[a] + 3;
  std::vector<std::uint8_t> mask(static_cast<std::size_t>(size[0]) * size[1] * size[2], 0);
  const auto mask_at = [&](int i, int j, int k) -> std::uint8_t& {
    return mask[(static_cast<std::size_t>(k) * size[1] + j) * size[0] + i];
  };
  for (int k = low[2]; k <= high[2]; ++k)
    for (int j = low[1]; j <= high[1]; ++j)
      for (int i = low[0]; i <= high[0]; ++i)
        mask_at(i - low[0] + 1, j - low[1] + 1, k - low[2] + 1) =
            choice.contains(volume.values[volume.grid.number(i, j, k)]);
  if (const Removed islands = remove_small_components(size, 1, 0, least_component, true, true, mask);
      islands.n_components > 0)
    region.notes.push_back(fmt::format("{} of fewer than {} voxels dropped ({})",
                                       counted(islands.n_components, "island", "islands"), least_component,
                                       counted(islands.n_voxels, "voxel", "voxels")));
  if (const Removed holes = remove_small_components(size, 0, 1, least_component, false, true, mask);
      holes.n_components > 0)
    region.notes.push_back(fmt::format("{} of fewer than {} voxels filled ({})",
                                       counted(holes.n_components, "cavity", "cavities"), least_component,
                                       counted(holes.n_voxels, "voxel", "voxels")));

  // What is left, by its place in the mask.
  IndexBox rest;
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i)
        if (mask_at(i, j, k)) rest.add({i, j, k});
  const std::array<int, 3> sides = block_sides(volume.grid, rest);
  VoxelGrid& grid = region.grid;
  Vec<3> first;  // index of the first voxel's centre in the volume
  for (std::size_t a = 0; a < 3; ++a) {
    const int n = rest.high[a] - rest.low[a] + 1;
    grid.size[a] = (n + sides[a] - 1) / sides[a] + 2 * region_margin;
    grid.axes.col(a) = sides[a] * volume.grid.axes.col(a);
    first[a] = low[a] + rest.low[a] - 1 + 0.5 * (sides[a] - 1) - region_margin * sides[a];
  }
  grid.origin = volume.grid.position(first);
  region.shares.assign(grid.n_voxels(), 0.0f);
  const float share = 1.0f / static_cast<float>(sides[0] * sides[1] * sides[2]);
  const auto block = [&](std::size_t a, int i) { return region_margin + (i - rest.low[a]) / sides[a]; };
  for (int k = rest.low[2]; k <= rest.high[2]; ++k)
    for (int j = rest.low[1]; j <= rest.high[1]; ++j)
      for (int i = rest.low[0]; i <= rest.high[0]; ++i)
        if (mask_at(i, j, k)) region.shares[grid.number(block(0, i), block(1, j), block(2, k))] += share;
  if (sides != std::array<int, 3>{1, 1, 1})
    region.notes.push_back(
        fmt::format("it is large: blocks of {} x {} x {} voxels are taken as one", sides[0], sides[1], sides[2]));
  return region;
}

}  // namespace shellmatch
