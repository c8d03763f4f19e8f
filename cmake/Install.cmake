# What `cmake --install` lays out: headers under include/shellmatch/, the modules as static libraries, the
# program, the documentation, the experiments, the examples, and a package for find_package(shellmatch).
include(CMakePackageConfigHelpers)

get_property(modules GLOBAL PROPERTY SHELLMATCH_MODULES)
set(shellmatch_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/shellmatch)

# Eigen's alignment depends on the vector unit, so that code including our headers must be compiled for the same machine
# as the libraries. SHELLMATCH_NATIVE=OFF (preset 'portable') builds libraries without this condition.
if(SHELLMATCH_NATIVE AND TARGET shellmatch_base)
  target_compile_options(shellmatch_base INTERFACE $<INSTALL_INTERFACE:-march=native>)
endif()

install(TARGETS ${modules} EXPORT shellmatch ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT shellmatch NAMESPACE shellmatch:: FILE ShellmatchTargets.cmake
  DESTINATION ${shellmatch_package_dir})
foreach(module ${modules})
  get_target_property(folder ${module} SOURCE_DIR)
  file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR} ${folder})
  cmake_path(GET folder PARENT_PATH parent)
  install(DIRECTORY ${folder} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/shellmatch/${parent} FILES_MATCHING
    PATTERN "*.h" PATTERN "cgal_*.h" EXCLUDE)
endforeach()

# The component `program` is what a package holds (cmake/Package.cmake).
if(TARGET shellmatch)
  install(TARGETS shellmatch RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
endif()

install(FILES README.md CHANGELOG.md CONTRIBUTING.md CITATION.cff LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program USE_SOURCE_PERMISSIONS)
install(DIRECTORY configs DESTINATION ${CMAKE_INSTALL_DATADIR}/shellmatch COMPONENT program)
install(DIRECTORY apps/studies/workflow DESTINATION ${CMAKE_INSTALL_DATADIR}/shellmatch/studies COMPONENT program)

configure_package_config_file(cmake/ShellmatchConfig.cmake.in ${PROJECT_BINARY_DIR}/shellmatchConfig.cmake
  INSTALL_DESTINATION ${shellmatch_package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/shellmatchConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/shellmatchConfig.cmake ${PROJECT_BINARY_DIR}/shellmatchConfigVersion.cmake
  DESTINATION ${shellmatch_package_dir})
