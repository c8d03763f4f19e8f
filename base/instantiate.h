#pragma once
/// \file
/// Explicit instantiation of templates over the dimension.

/// Instantiates a function template, whose body is in this source, for the plane and for space.
#define SHELLMATCH_2D_3D(function)            \
  template decltype(function<2>) function<2>; \
  template decltype(function<3>) function<3>
