# The shapes that ship with the program.
list(APPEND GEOMETRY_SOURCES
  exact_shape.cpp
  generate_beet.cpp
  generate_box.cpp
  generate_dolphin.cpp
  generate_face.cpp
  generate_families.cpp
  generate_hand.cpp
  generate_implicit.cpp
  generate_lattice.cpp
  generate_lattice_link.cpp
  generate_mesh_quality.cpp
  generate_outline.cpp
  generate_round.cpp
  generate_shape.cpp)
