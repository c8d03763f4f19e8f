#pragma once
/// \file
/// A page with its data, and the first view of its shapes in space.

#include "geometry/surface/surface.h"

#include <array>
#include <span>
#include <string>
#include <string_view>

namespace shellmatch {

/// \param page with the comments `<!-- data -->` and `<!-- arrays -->`, in whose places the texts come
/// \param data JSON without '<' \param arrays base64
std::string filled_page(std::string_view page, std::string_view data, std::string_view arrays);

/// In the coordinates in which the shapes are shown: what to look at, where up is and where the eye, and half of the
/// height that is seen there (matching/render/surfaces/camera.h).
struct PageView {
  std::array<double, 3> target, up, backward;
  double half_height;
};

/// A view that shows all surfaces whole, and most of them.
/// \pre at least one vertex
PageView page_view(std::span<const Surface<3>* const> surfaces);

}  // namespace shellmatch
