#pragma once
/// \file
/// Closes surfaces that do not quite bound a volume.

#include "geometry/surface/surface.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace shellmatch {

struct FilledHoles {
  Surface<3> surface;                  ///< closed; its first facets are those that were there
  std::size_t n_holes = 0, n_new = 0;  ///< holes, and the triangles that fill them
  double new_share = 0;                ///< of the area of the result
};

/// Fills every hole with triangles (CGAL's triangulate_hole: those that bend least, and of these the least area). Edges
/// with more than two triangles are taken apart first. None where a hole cannot be filled, or the result is not closed.
std::optional<FilledHoles> fill_holes(const Surface<3>& open);

/// The surface around any set of triangles that is at most `alpha` away in gaps and `offset` outside of them: closed,
/// without self-intersections, oriented outward (CGAL's alpha_wrap_3; Portaneri et al., Alpha wrapping with an offset,
/// 2022). Without facets where it fails. \pre alpha, offset > 0; at least one triangle
Surface<3> wrapped(const Surface<3>& triangles, double alpha, double offset);

/// What closed a surface.
struct Closure {
  Evidence<3> evidence;       ///< complete where nothing was made up
  double invented_share = 0;  ///< of the area of the closed surface
};

/// Puts the wrap around the surface in its place, and says so in `notes`, beginning with its `state`. \throws
/// InputError, which begins with `why`, where the wrap encloses next to nothing
Closure wrap_surface(Surface<3>& surface, std::string_view state, const std::string& why,
                     std::vector<std::string>& notes);

/// Closes a surface that is not closed: by filling its holes where these are small, by a wrap otherwise. Says so in
/// `notes`. \throws InputError with the place of a gap where even the wrap encloses next to nothing
Closure close_surface(Surface<3>& surface, const std::string& source, std::vector<std::string>& notes);

}  // namespace shellmatch
