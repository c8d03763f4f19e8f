list(APPEND MATCHING_SOURCES ceres_checker.cpp check_state.cpp direction_check.cpp element_check.cpp gradient_check.cpp
     gradient_json.cpp gradient_report.cpp kink_free.cpp run_gradient_check.cpp)
