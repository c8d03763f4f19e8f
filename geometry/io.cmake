# Reading, mending and writing of shapes.
list(APPEND GEOMETRY_SOURCES
  read_text.cpp read_mesh_formats.cpp read_obj.cpp read_off.cpp read_ply.cpp read_ply_header.cpp read_stl.cpp
  read_points.cpp read_mask.cpp read_pgm.cpp read_png.cpp read_shape.cpp
  repair.cpp repair_steps.cpp repair_triangulate.cpp repair_outline.cpp
  cgal_repair.cpp cgal_repair_flat.cpp cgal_repair_nesting.cpp
  cgal_repair_crossings.cpp
  write_shape.cpp write_ply.cpp)
list(APPEND GEOMETRY_LIBRARIES PNG::PNG)
