#include "apps/cohorts/report/shape_drawer.h"

#include "matching/render/surfaces/surfaces.h"

namespace shellmatch {

template <>
ShapeDrawer<3>::ShapeDrawer(std::span<const Surface<3>* const> all, int size)
    : view_(fit_camera(all, 1, {.margin = 0.03})), size_(size) {}

template <>
ShapeDrawer<2>::ShapeDrawer(std::span<const Surface<2>* const> all, int size) : view_(fit_frame(all)), size_(size) {}

template <>
Image ShapeDrawer<3>::draw(const Surface<3>& shape, const std::vector<double>& values, double scale_end) const {
  RenderSurface look{.surface = &shape};
  if (scale_end > 0) {
    look.paint = Paint::scalar;
    look.scalars = values;
    look.scalar_max = scale_end;
  }
  return render_surfaces({&look, 1}, view_,
                         {.width = size_, .height = size_, .samples = 3, .ambient_occlusion = false});
}

template <>
Image ShapeDrawer<2>::draw(const Surface<2>& shape, const std::vector<double>& values, double scale_end) const {
  RenderContour look{.contour = &shape, .fill_alpha = 0.6, .line_width = size_ / 50.0};
  if (scale_end > 0)
    for (const double d : values) look.vertex_colors.push_back(map_color(ColorMap::sequential, d / scale_end));
  return render_contours({&look, 1}, view_, size_, size_);
}

}  // namespace shellmatch
