# What `cmake --install` lays out: public headers under include/shellmatch/, one shared library, the
# program, the documentation, the experiments, the examples, and a package for find_package(shellmatch).
include(CMakePackageConfigHelpers)

include(cmake/PublicHeaders.cmake)
set(shellmatch_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/shellmatch)
if(NOT SHELLMATCH_PACKAGE)
  include(cmake/Library.cmake)
  install(TARGETS shellmatch_library EXPORT shellmatch LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(EXPORT shellmatch NAMESPACE shellmatch:: FILE ShellmatchTargets.cmake DESTINATION ${shellmatch_package_dir})
endif()
foreach(header ${shellmatch_public_headers})
  get_filename_component(folder ${header} DIRECTORY)
  install(FILES ${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/shellmatch/${folder})
endforeach()
# `cmake --install BUILD --component development` adds the others, for new terms, fields and solvers: these are not kept as they are.
foreach(folder base geometry alignment grid energies solvers matching)
  install(DIRECTORY ${folder} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/shellmatch COMPONENT development EXCLUDE_FROM_ALL FILES_MATCHING
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
