#pragma once
/// \file
/// TPS, the text format of F. James Rohlf's programs for morphometrics (tpsDig and others): landmarks, curves and
/// outlines of specimens, with the origin at the bottom left of their images.

#include "geometry/surface/space.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace shellmatch {

/// Points of CURVES= or OUTLINES=; the latter are closed.
struct TpsCurve {
  std::vector<Vec<2>> points;
  bool is_closed;
};

/// A specimen. Coordinates are as in the file: SCALE= multiplies them.
struct TpsSpecimen {
  std::optional<std::string> id, image;
  std::optional<double> scale;
  int dimension = 2;                             ///< of the landmarks: LM= or LM3=
  std::vector<std::optional<Vec<3>>> landmarks;  ///< none where the file has NA; z = 0 in the plane
  std::vector<TpsCurve> curves;
  Space space = Space::unsaid;  ///< of COMMENT=SPACE=LPS, as shellmatch writes it

  double factor() const { return scale.value_or(1); }
};

/// All of them, at least one. \throws InputError with file and line
std::vector<TpsSpecimen> parse_tps(const std::string& path, std::string_view bytes);

/// The one with that ID, else with that image's name, with its ending or without; or the only one where `part` is
/// empty. \throws InputError
const TpsSpecimen& chosen_specimen(const std::vector<TpsSpecimen>& specimens, const std::string& path,
                                   const std::string& part);

/// Its landmarks times its scale. \throws InputError where there are none or they are of the other dimension
template <int Dim>
std::vector<std::optional<Vec<Dim>>> scaled_landmarks(const TpsSpecimen& specimen, const std::string& path);

/// A line that says that coordinates were multiplied, or that only others' are; empty where none have a scale.
std::string scale_note(const std::vector<TpsSpecimen>& specimens, const TpsSpecimen& chosen);

/// Appends a specimen: LM= or LM3= with the number of points, a line for each, ID= with the name on one line, and the
/// frame as a comment. \param coordinates of the points, `dimension` (2 or 3) for each, nan where they are not known
void append_tps_specimen(std::string& text, std::string_view name, std::span<const double> coordinates,
                         std::size_t dimension, Space space = Space::unsaid);

}  // namespace shellmatch
