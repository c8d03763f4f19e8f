#pragma once
/// \file
/// Built-in shapes by name, wherever a file may stand.

#include "geometry/generate/exact_shape.h"
#include "geometry/surface/surface.h"

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace shellmatch {

/// Is `source` "generate:NAME" or "generate:NAME/VARIANT"?
bool is_generated_source(const std::string& source);

/// "NAME" or "NAME/VARIANT" in two; the variant is empty where it is not given.
std::pair<std::string, std::string> split_variant(const std::string& text);

/// Does nothing where there is such a shape; quick. \pre is_generated_source(source).
/// \throws InputError naming the shapes or variants that there are
void check_generated_source(const std::string& source);

/// The built-in shape with its default parameters and edge length. \pre is_generated_source(source).
/// \throws InputError naming the shapes or variants that there are
std::variant<OriginalShape<2>, OriginalShape<3>> generated_original(const std::string& source);

/// Distance and curvatures of the same shape by their formulas, if there are any.
std::optional<AnyExactShape> generated_formula(const std::string& source);

/// Where the vertices of the built-in shape `reference` truly go in `template_shape`: pairs of vertex and position.
/// Empty unless both are built-in shapes of one kind of which that is known (geometry/generate/generate_shape.h).
template <int Dim>
std::vector<std::pair<Index, Vec<Dim>>> generated_correspondence(const std::string& reference,
                                                                 const std::string& template_shape);

}  // namespace shellmatch
