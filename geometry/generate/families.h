#pragma once
/// \file
/// The table of all kinds of shapes with their options, variants and builders.

#include "geometry/generate/body.h"
#include "geometry/generate/generator_info.h"

#include <functional>
#include <string_view>
#include <variant>
#include <vector>

namespace shellmatch {

using AnyBody = std::variant<Body<2>, Body<3>>;

/// One kind of shape. `build` expects a value in range for every parameter.
struct Family {
  GeneratorInfo info;
  std::function<AnyBody(const GeneratorParameters&, double edge_length)> build;
};

/// In the order of the catalogue.
const std::vector<Family>& families();

/// The family of this name. \throws InputError naming all families and the nearest spelling.
const Family& find_family(std::string_view name);

/// All parameters of a variant, with the values of `parameters` in place of its own.
/// \throws InputError for unknown variants, unknown parameters and values out of range.
GeneratorParameters complete_parameters(const GeneratorInfo& info, std::string_view variant,
                                        const GeneratorParameters& parameters);

}  // namespace shellmatch
