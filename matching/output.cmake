list(APPEND MATCHING_SOURCES checksum.cpp curvature_comparison.cpp curvature_json.cpp curvature_pictures.cpp
     curvature_text.cpp file_lock.cpp file_seal.cpp grid_picture.cpp history_file.cpp json_kept_manifest.cpp json_summary.cpp kept_levels.cpp level_picture.cpp output_folder.cpp
     process_info.cpp rebuild_grid.cpp size_estimate.cpp verdict.cpp vtk_deformation_file.cpp)
set_property(SOURCE process_info.cpp APPEND PROPERTY COMPILE_DEFINITIONS SHELLMATCH_VERSION="${PROJECT_VERSION}")
