# Every third-party package, found once. Each has one adapter in the sources (docs/conventions.md).
# Their headers are SYSTEM headers, so that our warning flags judge our own code only.
find_package(Threads REQUIRED)
# Packages that refuse what asks for an earlier release than theirs are found without a version, which is looked at here.
function(shellmatch_at_least needed name found)
  if(found VERSION_LESS needed)
    message(FATAL_ERROR "${name} ${found} is too old: ${needed} or later is needed")
  endif()
endfunction()
find_package(Eigen3 REQUIRED NO_MODULE)
shellmatch_at_least(3.4 Eigen ${Eigen3_VERSION})
set(shellmatch_eigen_version ${Eigen3_VERSION})  # VTK's own module overwrites it
find_package(fmt 9 REQUIRED)
find_package(TBB REQUIRED)
find_package(nanoflann REQUIRED)
set(CMAKE_POLICY_DEFAULT_CMP0167 NEW)  # CMake 3.30 and later warn where packages of others look for Boost, too
find_package(Boost 1.74 REQUIRED CONFIG)
find_package(Spectra 1.0 REQUIRED)
find_package(Ceres 2.1 REQUIRED)
# Ceres' package configuration finds SuiteSparse if Ceres was built with it, as Debian's is.
if(NOT TARGET SuiteSparse::CHOLMOD)
  message(FATAL_ERROR "CHOLMOD is missing: this Ceres is built without SuiteSparse (Debian: libsuitesparse-dev, libceres-dev)")
endif()
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(PkgConfig REQUIRED)
# These two have CMake packages whose targets are named differently from release to release.
pkg_check_modules(NLOPT REQUIRED IMPORTED_TARGET nlopt>=2.7)
pkg_check_modules(YAML_CPP REQUIRED IMPORTED_TARGET yaml-cpp>=0.7)
pkg_check_modules(CAIRO REQUIRED IMPORTED_TARGET cairo)
pkg_check_modules(FONTCONFIG REQUIRED IMPORTED_TARGET fontconfig>=2.14)
pkg_check_modules(WEBP REQUIRED IMPORTED_TARGET libwebpmux libwebp>=1.2)
pkg_check_modules(XXHASH REQUIRED IMPORTED_TARGET libxxhash>=0.8)
pkg_check_modules(DEFLATE REQUIRED IMPORTED_TARGET libdeflate>=1.14)
find_package(PNG REQUIRED)
find_package(TIFF 4.5 REQUIRED)
pkg_check_modules(TURBOJPEG REQUIRED IMPORTED_TARGET libturbojpeg>=2.1)
find_package(ZLIB REQUIRED)
find_package(embree REQUIRED)
shellmatch_at_least(3 Embree ${embree_VERSION})
find_package(TinyGLTF REQUIRED)
shellmatch_at_least(2.7 TinyGLTF ${TinyGLTF_VERSION})
find_package(pugixml 1.13 REQUIRED)
set(CGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE TRUE)
find_package(CGAL 5.5 REQUIRED)
# VTK's package configuration requires the C language through its dependency on MPI.
enable_language(C)
find_package(VTK 9.1 REQUIRED COMPONENTS CommonCore CommonDataModel IOCore IOLegacy IOXML)
# What the page of a result is made from (matching/page/): JavaScript libraries, and the program that puts them into one file.
find_program(ESBUILD esbuild REQUIRED)
find_file(THREE_MODULE three.module.js PATHS /usr/share/javascript/three /usr/share/nodejs/three/build REQUIRED)
find_file(TRACKBALL_CONTROLS TrackballControls.js PATHS /usr/share/javascript/three/examples/jsm/controls REQUIRED)
find_path(NODE_MODULES chart.js/package.json PATHS /usr/share/nodejs REQUIRED)
include(cmake/LinkedLibraries.cmake)
if(SHELLMATCH_TESTS)
  find_package(GTest REQUIRED)
  find_package(assimp REQUIRED)                                       # writes the scenes that we read
  shellmatch_at_least(5.2 assimp ${assimp_VERSION})
  pkg_check_modules(WEBPDEMUX REQUIRED IMPORTED_TARGET libwebpdemux)  # reads our animations again
  # What our volumes are compared with. ITK's package configuration also reports programs of GDCM's that are not there, in ten lines each.
  set(CMAKE_MESSAGE_LOG_LEVEL NOTICE)
  # ITK 5.4's configuration loads all modules. This one looks for all of VTK, Qt, MPI and Python among it, overwrites VTK_LIBRARIES, and
  # fails beside Eigen 5: it counts as loaded.
  set(ITKVtkGlue_LOADED 1)
  find_package(ITK 5.2 REQUIRED COMPONENTS ITKCommon ITKTransform ITKIOImageBase ITKIOMeta ITKIONIFTI ITKIONRRD)
  unset(CMAKE_MESSAGE_LOG_LEVEL)
endif()
if(SHELLMATCH_PYTHON)
  # Debian's interpreter, which has Debian's numpy, unless another one is named; pip names its own
  # (python/backend/shellmatch_backend.py). Found before pybind11, which takes the same.
  if(NOT Python_EXECUTABLE AND EXISTS /usr/bin/python3)
    set(Python_EXECUTABLE /usr/bin/python3 CACHE FILEPATH "The interpreter that the Python module is for")
  endif()
  find_package(Python 3.11 REQUIRED COMPONENTS Interpreter Development.Module)
  find_package(pybind11 2.10 REQUIRED)
endif()
if(SHELLMATCH_BENCH)
  find_package(benchmark REQUIRED)
endif()
