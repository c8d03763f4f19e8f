list(APPEND MATCHING_SOURCES
  generated_source.cpp
  inspection.cpp
  inspection_json.cpp
  level_solver.cpp
  option_text.cpp
  options.cpp
  shape_source.cpp
  yaml_document.cpp
  yaml_options.cpp
  yaml_write.cpp)
