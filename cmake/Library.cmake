# One shared library of all modules: a program that links it needs none of the libraries behind it but Eigen and fmt, whose types are in
# the public headers.
set(modules base geometry statistics alignment grid energies solvers render matching)
list(TRANSFORM modules PREPEND shellmatch_ OUTPUT_VARIABLE archives)
list(TRANSFORM archives REPLACE "(.+)" "$<TARGET_OBJECTS:\\1>" OUTPUT_VARIABLE objects)
file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/library.cpp CONTENT "// The library's code is in the modules.\n")
add_library(shellmatch_library SHARED ${PROJECT_BINARY_DIR}/library.cpp ${objects})
set_target_properties(shellmatch_library PROPERTIES OUTPUT_NAME shellmatch EXPORT_NAME library SOVERSION ${PROJECT_VERSION})
target_link_libraries(shellmatch_library PRIVATE ${archives} $<BUILD_INTERFACE:shellmatch_flags>
                      INTERFACE Eigen3::Eigen fmt::fmt)
# Its own copies of inline functions, which are compiled for its processors, are not replaced by those of a program.
target_link_options(shellmatch_library PRIVATE -Wl,-Bsymbolic)
target_include_directories(shellmatch_library INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/shellmatch>)
target_compile_features(shellmatch_library INTERFACE cxx_std_20)

# Eigen aligns its types by the vector unit. Programs get that number, not the flags of the processor.
set(march "")
if(shellmatch_built_for)
  set(march -march=${shellmatch_built_for})
endif()
execute_process(COMMAND ${CMAKE_CXX_COMPILER} ${march} -dM -E -x c++ /dev/null OUTPUT_VARIABLE macros COMMAND_ERROR_IS_FATAL ANY)
set(alignment 16)
if(macros MATCHES "__AVX512F__")
  set(alignment 64)
elseif(macros MATCHES "__AVX__")
  set(alignment 32)
endif()
target_compile_definitions(shellmatch_library INTERFACE $<INSTALL_INTERFACE:EIGEN_MAX_ALIGN_BYTES=${alignment}>)
