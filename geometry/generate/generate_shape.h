#pragma once
/// \file
/// The shapes that ship with the program, made on demand: closed, oriented outward, free of
/// self-intersections and inside [0.1, 0.9]^Dim with their own parameters; the same bits on every call.

#include "geometry/generate/generator_info.h"
#include "geometry/surface/surface.h"

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace shellmatch {

/// All kinds of shapes, solids first.
std::vector<GeneratorInfo> generator_catalogue();

/// An outline or a surface.
using AnyOriginal = std::variant<OriginalShape<2>, OriginalShape<3>>;

/// Shape `name` in its `variant` ("" is the first), single parameters changed, with edges of about
/// `edge_length` sides of the domain (0: the shape's own default; else 0.003 to 0.05). \throws InputError for
/// an unknown name, variant or parameter, naming those that exist and the nearest spelling; for values out of
/// range; and for a shape that leaves [0.05, 0.95]^Dim.
AnyOriginal generate_shape(std::string_view name, std::string_view variant = "", double edge_length = 0,
                        const GeneratorParameters& parameters = {});

/// Where a vertex of the reference truly goes.
template <int Dim>
struct KnownPosition {
  Index vertex;  ///< of the reference
  Vec<Dim> position;
};

template <int Dim>
using KnownPositions = std::vector<KnownPosition<Dim>>;
using AnyKnownPositions = std::variant<KnownPositions<2>, KnownPositions<3>>;

/// Where the vertices of generate_shape(name, from) go in variant `to`, ascending by vertex, on the exact surface, to
/// rounding. Empty where nothing is known (beet, face); all vertices where a map of the shape is known; for the hand
/// those whose motion is rigid. \throws InputError for an unknown name or variant
AnyKnownPositions known_positions(std::string_view name, std::string_view from, std::string_view to);

/// Two shapes to be matched, tessellated differently.
template <int Dim>
struct GeneratedPair {
  OriginalShape<Dim> reference, template_shape;
  KnownPositions<Dim> truth;  ///< as known_positions()
};

using AnyPair = std::variant<GeneratedPair<2>, GeneratedPair<3>>;

/// The standard pair of each kind of shape, by the name of the kind: its first two variants.
/// `edge_length` as above, for the reference; the edges of the template are a fifth longer.
/// \throws InputError for an unknown name.
AnyPair generated_pair(std::string_view name, double edge_length = 0);

}  // namespace shellmatch
