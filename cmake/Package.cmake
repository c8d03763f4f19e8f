# The program as a Debian package (scripts/package): a small executable and one shared library with all of our code. The library is
# compiled for several processors, each in a build tree of its own (SHELLMATCH_ARCHITECTURE), and the dynamic loader takes the best
# that the machine has from the folders glibc-hwcaps/ beside the first one (glibc 2.33 or later, `man ld.so`).
set(SHELLMATCH_PACKAGE_VARIANTS "" CACHE STRING "Build trees of the further variants of the library")

# Ceres uses Eigen as well, and is compiled for any processor: its memory is aligned differently. It is therefore linked as a shared
# library, which its package configuration does not offer, and our library exports one function only, so that neither calls the
# other's copies of Eigen's inline functions.
find_library(SHELLMATCH_SHARED_CERES NAMES libceres.so REQUIRED)
set_target_properties(Ceres::ceres PROPERTIES IMPORTED_LOCATION ${SHELLMATCH_SHARED_CERES} IMPORTED_LOCATION_RELEASE ${SHELLMATCH_SHARED_CERES})
set(exports ${PROJECT_SOURCE_DIR}/cmake/package/exports.map)
# The same bytes whatever the folders of sources and builds are called, and where ccache makes paths relative (base_dir). The last
# option that fits counts.
file(RELATIVE_PATH to_sources ${PROJECT_BINARY_DIR} ${PROJECT_SOURCE_DIR}/CMakeLists.txt)
get_filename_component(to_sources ${to_sources} DIRECTORY)
target_compile_options(shellmatch_flags INTERFACE -fvisibility=hidden -ffile-prefix-map=${to_sources}/=
  -ffile-prefix-map=${PROJECT_SOURCE_DIR}/= -ffile-prefix-map=${PROJECT_BINARY_DIR}/=build/)
# Without the table of symbols (-s), which has the names of files in it and enters the build's identifier.
set(link_options -s -Wl,--as-needed -Wl,-z,relro,-z,now)
target_link_options(shellmatch_program PRIVATE ${link_options} -Wl,-z,defs -Wl,--version-script=${exports})
target_link_options(shellmatch PRIVATE ${link_options} -Wl,-z,defs)
set_target_properties(shellmatch_program PROPERTIES LINK_DEPENDS ${exports} OUTPUT_NAME shellmatch SOVERSION ${PROJECT_VERSION})
# Not right below lib/, for whose folders CPack adds scripts that call ldconfig.
set(folder lib/${CMAKE_LIBRARY_ARCHITECTURE}/shellmatch)
# In the build tree, too, the library is found relative to the executable: installing replaces the path but not the space that it takes.
set_target_properties(shellmatch PROPERTIES BUILD_RPATH_USE_ORIGIN ON INSTALL_RPATH "$ORIGIN/../${folder}")

if(SHELLMATCH_ARCHITECTURE MATCHES "^x86-64-v[234]$")
  string(APPEND folder /glibc-hwcaps/${SHELLMATCH_ARCHITECTURE})
endif()
if(SHELLMATCH_PYTHON)
  target_link_options(shellmatch_core PRIVATE ${link_options})  # functions of Python are those of the process
endif()
install(TARGETS shellmatch_program LIBRARY DESTINATION ${folder} COMPONENT vector_code NAMELINK_SKIP)
install(FILES cmake/package/copyright DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
# The notices of the libraries whose code is compiled into ours, as Debian has them.
foreach(package libboost-dev libceres-dev libcgal-dev libcli11-dev libeigen3-dev libfmt-dev libnanoflann-dev libspectra-dev
        nlohmann-json3-dev libjs-three node-chart.js)
  string(REPLACE boost boost${Boost_VERSION_MAJOR}.${Boost_VERSION_MINOR} installed ${package})
  install(FILES /usr/share/doc/${installed}/copyright DESTINATION ${CMAKE_INSTALL_DOCDIR}/licences RENAME ${package} COMPONENT program)
endforeach()

set(CPACK_GENERATOR DEB)
set(CPACK_INSTALL_CMAKE_PROJECTS "${PROJECT_BINARY_DIR};shellmatch;program;/" "${PROJECT_BINARY_DIR};shellmatch;vector_code;/")
foreach(tree ${SHELLMATCH_PACKAGE_VARIANTS})
  list(APPEND CPACK_INSTALL_CMAKE_PROJECTS "${tree};shellmatch;vector_code;/")
endforeach()
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "shape-aware matching of implicit surfaces with thin shell energies")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "Finds the deformation of the unit square or cube that maps a closed shape
onto another with the least energy of a thin elastic shell. Shapes are
meshes, contours or masks; the map applies to anything in space. Code for
AVX-512, AVX2 and SSE2 is in this package; the right one is chosen when the
program starts.")
# scripts/package passes CPACK_DEBIAN_PACKAGE_VERSION and CPACK_PACKAGE_CONTACT to cpack.
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_DEPENDS fonts-dejavu-core)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/apps)
# Before the files are packed: pages and compressed files as Debian has them, and the same times and rights everywhere.
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/package/finish.cmake)
set(CPACK_VERBATIM_VARIABLES ON)
include(CPack)
