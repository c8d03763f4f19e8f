// CGAL's tree over triangles, of which CGAL 6 names the dimension.
#pragma once

#include <CGAL/AABB_tree.h>
#include <CGAL/version.h>
#if CGAL_VERSION_NR >= 1060001000
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_triangle_primitive_3.h>
#else
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_triangle_primitive.h>
#endif

namespace shellmatch {

#if CGAL_VERSION_NR >= 1060001000
template <class Kernel, class Iterator>
using CgalTriangleTree =
    CGAL::AABB_tree<CGAL::AABB_traits_3<Kernel, CGAL::AABB_triangle_primitive_3<Kernel, Iterator>>>;
#else
template <class Kernel, class Iterator>
using CgalTriangleTree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_triangle_primitive<Kernel, Iterator>>>;
#endif

}  // namespace shellmatch
