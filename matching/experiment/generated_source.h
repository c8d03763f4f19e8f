#pragma once
/// \file
/// Built-in shapes by name, which can be given wherever a file can.

#include "geometry/generate/exact_shape.h"
#include "geometry/surface/surface.h"

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace shellmatch {

/// Whether `source` is "generate:NAME" or "generate:NAME/VARIANT".
bool is_generated_source(const std::string& source);

/// Splits "NAME" or "NAME/VARIANT"; the variant is empty if it is not given.
std::pair<std::string, std::string> split_variant(const std::string& text);

/// Checks that there is such a shape, without generating it in full. \pre is_generated_source(source).
/// \throws InputError with the names of the shapes or variants
void check_generated_source(const std::string& source);

/// The built-in shape with its default parameters and edge length. \pre is_generated_source(source).
/// \throws InputError with the names of the shapes or variants
std::variant<OriginalShape<2>, OriginalShape<3>> generated_original(const std::string& source);

/// Distance and curvatures of the same shape by formulas, if there are any.
std::optional<AnyExactShape> generated_formula(const std::string& source);

/// The true images of vertices of the built-in shape `reference` in `template_shape`, as pairs of vertex and position.
/// Empty unless both are built-in shapes of one kind with a known correspondence (geometry/generate/generate_shape.h).
template <int Dim>
std::vector<std::pair<Index, Vec<Dim>>> generated_correspondence(const std::string& reference,
                                                                 const std::string& template_shape);

}  // namespace shellmatch
