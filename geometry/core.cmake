# Measures of surfaces: placement, distance and sign, curvature, distortion.
list(APPEND GEOMETRY_SOURCES
  surface.cpp
  placement.cpp
  facet_point.cpp
  facet_tree.cpp
  pseudonormals.cpp
  signed_distance.cpp
  winding_number.cpp
  surface_distance.cpp
  distortion.cpp
  cgal_curvature.cpp
  curve_curvature.cpp
  cgal_self_intersections.cpp)

# GCC 12 takes the undefined lanes of its own AVX-512 intrinsics, which Eigen's decompositions use, for an error.
set_source_files_properties(cgal_curvature.cpp PROPERTIES
  COMPILE_OPTIONS $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
