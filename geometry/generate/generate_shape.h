#pragma once
/// \file
/// The built-in shapes, generated on demand. They are closed, oriented outward, free of self-intersections
/// and, with default parameters, inside [0.1, 0.9]^Dim. Every call yields the same bits.

#include "geometry/generate/generator_info.h"
#include "geometry/surface/surface.h"

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace shellmatch {

/// All kinds of shapes, those in space first.
std::vector<GeneratorInfo> generator_catalogue();

/// An outline or a surface.
using AnyOriginal = std::variant<OriginalShape<2>, OriginalShape<3>>;

/// Generates the shape `name` in its `variant` ("" is the first) with edges of about `edge_length` sides of
/// the domain (0: the default of the shape; else 0.003 to 0.05). `parameters` override those of the variant.
/// \throws InputError for an unknown name, variant or parameter, naming those that exist and the nearest
/// spelling; for values out of range; and for a shape that leaves [0.05, 0.95]^Dim.
AnyOriginal generate_shape(std::string_view name, std::string_view variant = "", double edge_length = 0,
                           const GeneratorParameters& parameters = {});

/// The exact image of a vertex of the reference.
template <int Dim>
struct KnownPosition {
  Index vertex;  ///< of the reference
  Vec<Dim> position;
};

template <int Dim>
using KnownPositions = std::vector<KnownPosition<Dim>>;
using AnyKnownPositions = std::variant<KnownPositions<2>, KnownPositions<3>>;

/// The exact images of the vertices of generate_shape(name, from) in variant `to`, ascending by vertex; they
/// lie on the surface up to rounding. Empty for shapes without a known correspondence (beet, face); for the
/// hand, the vertices that move rigidly; for other shapes, all vertices. \throws InputError for an unknown
/// name or variant
AnyKnownPositions known_positions(std::string_view name, std::string_view from, std::string_view to);

/// Two shapes to match, with different triangulations.
template <int Dim>
struct GeneratedPair {
  OriginalShape<Dim> reference, template_shape;
  KnownPositions<Dim> truth;  ///< as known_positions()
};

using AnyPair = std::variant<GeneratedPair<2>, GeneratedPair<3>>;

/// The standard pair of the kind of shape `name`: its first two variants. `edge_length` is that of the
/// reference, as above; the edges of the template are 20 % longer.
/// \throws InputError for an unknown name.
AnyPair generated_pair(std::string_view name, double edge_length = 0);

}  // namespace shellmatch
