#pragma once
/// \file
/// What a matching is made from, as Python hands it over: shapes, options and landmarks.

#include <pybind11/pybind11.h>

#include "matching/experiment/options.h"
#include "matching/input/shape_pair.h"
#include "matching/input/shape_source.h"
#include "matching/pairs/landmarks.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace shellmatch::python {

/// The class ShapeInput: file(), mesh(), rings(), volume().
void bind_shape_input(pybind11::module_& module);

/// Options as full key, value in YAML's notation, and the beginning of messages.
using OptionTexts = std::vector<std::tuple<std::string, std::string, std::string>>;

/// The options of a YAML file, where `config` names one, changed by these. `input` names the shapes that are
/// files, and no others. \throws InputError, also for options of runs that have files alone
ExperimentOptions options_of(const std::string& config, const OptionTexts& texts,
                             const std::array<ShapeInput, 2>& shapes);

/// Points of one shape: positions, or numbers of its vertices.
struct GivenPoints {
  std::vector<double> positions;       ///< row by row
  std::vector<std::int64_t> vertices;  ///< where there are no positions
  int n_columns = 0;                   ///< of the positions; 0 for vertices
  std::size_t size() const {
    return n_columns > 0 ? positions.size() / static_cast<std::size_t>(n_columns) : vertices.size();
  }
};

struct GivenLandmarks {
  std::array<GivenPoints, 2> sides;  ///< on the reference, on the template; of one size
  std::vector<double> weights;       ///< one for each, or none
};

/// What match() would refuse whatever the template is: options, the reference, landmarks on it. \throws InputError
void check_all_but_template(const ShapeInput& reference, const OptionTexts& texts, const std::string& config,
                            const pybind11::object& landmarks);

/// From None or (points, points, weights or None). \throws InputError
GivenLandmarks landmarks_from(const pybind11::object& given);

/// The landmarks of the files that the options name, or those given. \throws InputError
template <int Dim>
std::vector<Landmark<Dim>> landmarks_of(const GivenLandmarks& given, const ExperimentOptions& options,
                                        const ShapePair<Dim>& shapes, Observer& observer);

}  // namespace shellmatch::python
