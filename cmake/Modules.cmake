# One static library per folder, with the same flags everywhere.
include(GNUInstallDirs)

add_library(shellmatch_warnings INTERFACE)
target_compile_options(shellmatch_warnings INTERFACE
  -Wall -Wextra -Wshadow -Wpedantic -Wnon-virtual-dtor -Woverloaded-virtual
  # GCC 12 reports uninitialised values within its own AVX-512 intrinsics, which Eigen uses (GCC bug 105593).
  -Wno-maybe-uninitialized
  # Packs of eight doubles are passed by value, whose convention depends on the available registers. All files of a
  # build have the same flags, so that they agree.
  -Wno-psabi)
# Compilers that are newer than those of the supported systems warn of what nobody has seen.
set(shellmatch_werror ${SHELLMATCH_WERROR})
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 15)
  set(shellmatch_werror OFF)
endif()
if(shellmatch_werror)
  target_compile_options(shellmatch_warnings INTERFACE -Werror)
endif()
add_library(shellmatch_flags INTERFACE)
target_link_libraries(shellmatch_flags INTERFACE shellmatch_warnings)
# 512-bit registers are made available to the packs of quadrature points (energies/), where the processors have them.
set(shellmatch_built_for "${SHELLMATCH_ARCHITECTURE}")
if(SHELLMATCH_NATIVE)
  set(shellmatch_built_for native)
endif()
if(shellmatch_built_for)
  target_compile_options(shellmatch_flags INTERFACE -march=${shellmatch_built_for})
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    target_compile_options(shellmatch_flags INTERFACE -mprefer-vector-width=512)
  endif()
endif()
if(SHELLMATCH_SANITIZE)
  target_compile_options(shellmatch_flags INTERFACE -fsanitize=${SHELLMATCH_SANITIZE} -fno-omit-frame-pointer
                         -fno-sanitize-recover=all)
  target_link_options(shellmatch_flags INTERFACE -fsanitize=${SHELLMATCH_SANITIZE})
endif()

add_library(shellmatch_quick INTERFACE)
# With -O1 GCC 12 calls the undefined lanes of its AVX-512 intrinsics uninitialised, not only maybe so (GCC bug 105593).
target_compile_options(shellmatch_quick INTERFACE $<$<CONFIG:Release>:-O1> $<$<CXX_COMPILER_ID:GNU>:-Wno-uninitialized>)

# Headers that nearly all files include are precompiled once for all targets with the same flags. Every source still
# includes all headers that it uses; builds without precompiled headers check this (preset 'tidy', or
# CMAKE_DISABLE_PRECOMPILE_HEADERS=ON).
set(shellmatch_precompiled_headers <Eigen/Core> <fmt/format.h> <algorithm> <array> <cmath> <cstdint> <filesystem> <functional>
    <limits> <map> <memory> <optional> <span> <string> <string_view> <utility> <variant> <vector>)
target_compile_options(shellmatch_flags INTERFACE
  # Lets ccache see which precompiled header a file uses.
  $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>
  # With a precompiled header g++ no longer knows the standard library as a system header, and reports false alarms in
  # its strings.
  $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds>
  $<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overread>
  $<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overflow>
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)

# shellmatch_unity(target sources...)
#
# Compiles up to twelve sources of a room together, so that the headers and templates that they share are read and made once.
# Names of anonymous namespaces are therefore unique in a room. Every source still compiles alone (presets 'dev' and 'tidy').
# The source property SHELLMATCH_UNIT names another unit, or `alone` for a source that takes long by itself.
function(shellmatch_unity target)
  if(NOT SHELLMATCH_UNITY)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  # Names of anonymous namespaces are local to the unit, not to the file that g++ sees included.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
  foreach(source ${ARGN})
    get_source_file_property(unit ${source} SHELLMATCH_UNIT)
    get_source_file_property(own_headers ${source} SKIP_PRECOMPILE_HEADERS)
    if(unit AND NOT unit STREQUAL alone)
      set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${unit})
    elseif(NOT unit AND NOT own_headers)
      get_filename_component(room ${source} DIRECTORY)
      string(MAKE_C_IDENTIFIER "${target}_${room}" room)
      math(EXPR n_${room} "${n_${room}} + 1")
      math(EXPR group "(${n_${room}} - 1) / 12")
      set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${room}_${group})
    endif()
  endforeach()
endfunction()

# Modules that call the others and have no loops of their own that count: what matters is that they compile quickly.
set(shellmatch_callers render matching studies cohorts)

# shellmatch_module(name SOURCES ... PUBLIC targets... PRIVATE targets...)
function(shellmatch_module name)
  cmake_parse_arguments(ARG "" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  add_library(shellmatch_${name} STATIC ${ARG_SOURCES})
  add_library(shellmatch::${name} ALIAS shellmatch_${name})
  set_target_properties(shellmatch_${name} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
  target_include_directories(shellmatch_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/shellmatch>)
  target_compile_features(shellmatch_${name} PUBLIC cxx_std_20)
  target_link_libraries(shellmatch_${name} PUBLIC ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE}
                        $<BUILD_INTERFACE:shellmatch_flags>)
  # g++ silently takes code generation flags from the precompiled header instead of the command line. Geometry therefore
  # has its own, or CGAL's -frounding-math would be lost, and so have the callers.
  if(name IN_LIST shellmatch_callers)
    target_link_libraries(shellmatch_${name} PRIVATE $<BUILD_INTERFACE:shellmatch_quick>)
  endif()
  if(name MATCHES "^(base|geometry)$")
    target_precompile_headers(shellmatch_${name} PRIVATE ${shellmatch_precompiled_headers})
  elseif(name STREQUAL render)  # the first of the callers
    target_precompile_headers(shellmatch_${name} PRIVATE ${shellmatch_precompiled_headers})
  elseif(name IN_LIST shellmatch_callers)
    target_precompile_headers(shellmatch_${name} REUSE_FROM shellmatch_render)
  else()
    target_precompile_headers(shellmatch_${name} REUSE_FROM shellmatch_base)
  endif()
  shellmatch_unity(shellmatch_${name} ${ARG_SOURCES})
  set_property(GLOBAL APPEND PROPERTY SHELLMATCH_MODULES shellmatch_${name})
endfunction()
