#pragma once
/// \file
/// Pictures of a result with a chosen view, colour and time.

#include "base/options.h"
#include "geometry/surface/surface.h"
#include "matching/render/canvas/canvas.h"

#include <optional>
#include <string>
#include <vector>

namespace shellmatch {

/// All in the coordinates of the template; the reference as alignment has turned it.
template <int Dim>
struct ResultShapes {
  Surface<Dim> reference;  ///< with the vertices and facets of `deformed`
  Surface<Dim> deformed, template_shape;
  std::vector<double> distance_to_template, measure_ratio;  ///< at the vertices of `deformed`
  std::vector<double> distance_to_deformed;                 ///< at those of the template
  std::string unit;                                         ///< of lengths; empty where nobody has said
};

/// Reads deformed.ply, template.ply (.csv), deformation.vtu, config.yaml and the reference that this names.
/// \throws InputError where one of them is missing, damaged, or the reference is not that of the result
template <int Dim>
ResultShapes<Dim> read_result_shapes(const std::string& folder);

enum class ShownShapes { result, reference, template_shape, overlay, all };
template <>
struct EnumNames<ShownShapes> {
  static constexpr std::pair<ShownShapes, std::string_view> names[] = {{ShownShapes::result, "result"},
                                                                       {ShownShapes::reference, "reference"},
                                                                       {ShownShapes::template_shape, "template"},
                                                                       {ShownShapes::overlay, "overlay"},
                                                                       {ShownShapes::all, "all"}};
};

enum class ShownColors { checker, distance, distortion, plain };
template <>
struct EnumNames<ShownColors> {
  static constexpr std::pair<ShownColors, std::string_view> names[] = {{ShownColors::checker, "checker"},
                                                                       {ShownColors::distance, "distance"},
                                                                       {ShownColors::distortion, "distortion"},
                                                                       {ShownColors::plain, "plain"}};
};

struct ResultView {
  ShownShapes show = ShownShapes::result;
  ShownColors colors = ShownColors::checker;
  std::optional<double> azimuth, elevation;  ///< degrees, as ViewOptions; chosen if not given
  double turn = 0;     ///< degrees by which the camera goes around the shapes from there; 0 in the plane
  bool turns = false;  ///< whether other pictures have another turn, so that there is room for all of them
  double time = 1;     ///< t of phi_t = (1 - t) id + t phi
  int size = 800;      ///< side of a panel in pixels
};

/// Panels with captions and, where colours have a scale, a bar with its unit.
template <int Dim>
Canvas draw_result(const ResultShapes<Dim>& shapes, const ResultView& view, CanvasKind kind);

}  // namespace shellmatch
