#pragma once
/// \file
/// Description of a kind of shape: its parameters, variants and defaults.

#include "base/options.h"

#include <map>
#include <string>
#include <vector>

namespace shellmatch {

/// Values of parameters by name; values of integer parameters are whole numbers.
using GeneratorParameters = std::map<std::string, double>;

struct GeneratorParameter {
  std::string name;
  double default_value;  ///< of the first variant
  bool whole_number;
  OptionInfo info;  ///< unit, range, meaning
};

/// A named set of parameters: a pose or an individual.
struct GeneratorVariant {
  std::string name, meaning;
  GeneratorParameters values;  ///< of all parameters
};

/// Description of one kind of shape.
struct GeneratorInfo {
  std::string name, meaning;
  int dimension;                           ///< 2 or 3
  int genus;                               ///< 0, or 1 for the torus; 0 in the plane
  double edge_length;                      ///< default length of edges, in sides of the domain
  std::vector<GeneratorVariant> variants;  ///< the first is the default
  std::vector<GeneratorParameter> parameters;
};

}  // namespace shellmatch
