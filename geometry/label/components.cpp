#include "geometry/label/components.h"

#include <algorithm>
#include <cstdlib>

namespace shellmatch {

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

}  // namespace shellmatch
