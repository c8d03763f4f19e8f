#include "matching/report/page_view.h"

#include "matching/render/surfaces/camera.h"

namespace shellmatch {

PageView page_view(std::span<const Surface<3>* const> surfaces) {
  const Camera camera = fit_camera(surfaces, 1);
  const auto array_of = [](const Vec<3>& x) { return std::array{x[0], x[1], x[2]}; };
  return {array_of(camera.target), array_of(camera.up), array_of(camera.backward), camera.half_height};
}

}  // namespace shellmatch
