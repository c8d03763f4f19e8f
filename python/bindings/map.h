#pragma once
/// \file
/// The class Map: a deformation of the plane or of space, applied to arrays of points.

#include "matching/level/deformation.h"

#include <pybind11/numpy.h>

#include <memory>
#include <string>
#include <variant>

namespace shellmatch::python {

/// A map and, once they are asked for, its trees for points. Values of its functions are NaN where the map
/// has none.
template <int Dim>
class MapOf {
 public:
  explicit MapOf(std::shared_ptr<const Deformation<Dim>> map) : map_(std::move(map)) {}

  /// \pre within compute()
  const PointMap<Dim>& toward(Toward toward) {
    std::unique_ptr<PointMap<Dim>>& points = points_[toward == Toward::reference ? 1 : 0];
    if (!points) points = std::make_unique<PointMap<Dim>>(*map_, toward);
    return *points;
  }
  const Deformation<Dim>& deformation() const { return *map_; }

 private:
  std::shared_ptr<const Deformation<Dim>> map_;
  std::unique_ptr<PointMap<Dim>> points_[2];
};

/// A map of either dimension, shared by the objects of Python's that show it.
class Map {
 public:
  template <int Dim>
  explicit Map(std::shared_ptr<const Deformation<Dim>> map) : map_(std::make_shared<MapOf<Dim>>(std::move(map))) {}

  int dimension() const { return map_.index() == 0 ? 2 : 3; }
  pybind11::array_t<double> carry(const pybind11::array& points, Toward toward) const;
  pybind11::array_t<double> jacobian(const pybind11::array& points) const;

  std::variant<std::shared_ptr<MapOf<2>>, std::shared_ptr<MapOf<3>>> map_;
};

/// Class Map and the function load_map.
void bind_map(pybind11::module_& module);

}  // namespace shellmatch::python
