#pragma once
/// \file
/// Connected components of voxels.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace shellmatch {

/// Gives all voxels of value `from` in components of fewer than `least` voxels the value `to`. \param diagonal voxels
/// are neighbours across edges and corners, too, and not across faces alone \param keep_largest the largest component
/// stays in any case \return how many components and voxels that were
struct Removed {
  std::size_t n_components = 0, n_voxels = 0;
};
Removed remove_small_components(const std::array<int, 3>& size, std::uint8_t from, std::uint8_t to, std::size_t least,
                                bool diagonal, bool keep_largest, std::vector<std::uint8_t>& voxels);

}  // namespace shellmatch
