#pragma once
/// \file
/// The table behind generate_shape: every kind of shape with its options, variants and builder.

#include "geometry/generate/body.h"
#include "geometry/generate/generator_info.h"

#include <functional>
#include <string_view>
#include <variant>
#include <vector>

namespace shellmatch {

using AnyBody = std::variant<Body<2>, Body<3>>;

/// One kind of shape. `build` takes every parameter by name; the values are in range.
struct Family {
  GeneratorInfo info;
  std::function<AnyBody(const GeneratorParameters&, double edge_length)> build;
};

/// In the order of the catalogue.
const std::vector<Family>& families();

/// \throws InputError naming those that exist and the nearest spelling.
const Family& find_family(std::string_view name);

/// All parameters of a variant with those changed that `parameters` names.
/// \throws InputError for unknown variants, unknown parameters and values out of range.
GeneratorParameters complete_parameters(const GeneratorInfo& info, std::string_view variant,
                                        const GeneratorParameters& parameters);

}  // namespace shellmatch
