list(APPEND MATCHING_SOURCES deformation.cpp level_metric.cpp level_problem.cpp cascade.cpp run_matching.cpp run_report.cpp
     field_grid.cpp shape_fields.cpp shape_pair.cpp)
