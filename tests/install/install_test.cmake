# Installs BUILD_DIR below WORK_DIR, moves it (an installation must not remember where it was made), and
# configures, builds and runs the program in CONSUMER_DIR and the installed examples against it.

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "failed (${result}): ${command}\n${output}")
  endif()
endfunction()

# Information for a debugger takes long to write, and nobody debugs these. Without -Og examples run longer than they
# are built.
set(flags -DCMAKE_CXX_FLAGS_DEBUG=-Og)
set(compiler_flags "")
if(WERROR)
  string(APPEND compiler_flags " -Wall -Wextra -Wpedantic -Wshadow -Wno-maybe-uninitialized -Wno-uninitialized -Werror")
endif()
if(SANITIZE)
  string(APPEND compiler_flags " -fsanitize=${SANITIZE}")
endif()
if(compiler_flags)
  list(APPEND flags "-DCMAKE_CXX_FLAGS=${compiler_flags}")
endif()

file(REMOVE_RECURSE ${WORK_DIR})
run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${WORK_DIR}/made-here)
file(RENAME ${WORK_DIR}/made-here ${WORK_DIR}/prefix)

foreach(file bin/shellmatch include/shellmatch/matching/match_shapes.h include/shellmatch/base/error.h include/shellmatch/matching/experiment/options.h
        share/shellmatch/configs/hand.yaml share/shellmatch/studies/workflow/Snakefile)
  if(NOT EXISTS ${WORK_DIR}/prefix/${file})
    message(FATAL_ERROR "${file} was not installed")
  endif()
endforeach()

run(${CMAKE_COMMAND} -S ${CONSUMER_DIR} -B ${WORK_DIR}/build -G ${GENERATOR} -DCMAKE_BUILD_TYPE=Debug
    -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_PREFIX_PATH=${WORK_DIR}/prefix ${flags})
run(${CMAKE_COMMAND} --build ${WORK_DIR}/build)
run(${WORK_DIR}/build/consumer)

# The public headers need no other, and no library but Eigen and fmt; immintrin.h is the compiler's.
file(GLOB_RECURSE headers RELATIVE ${WORK_DIR}/prefix/include/shellmatch ${WORK_DIR}/prefix/include/shellmatch/*.h)
list(LENGTH headers n_headers)
if(n_headers GREATER 80)
  message(FATAL_ERROR "${n_headers} public headers, more than 80")
endif()
foreach(header ${headers})
  file(STRINGS ${WORK_DIR}/prefix/include/shellmatch/${header} includes REGEX "^#include [<\"]")
  foreach(include ${includes})
    string(REGEX REPLACE "^#include [<\"]([^>\"]*).*" "\\1" path "${include}")
    if(include MATCHES "\"" AND NOT EXISTS ${WORK_DIR}/prefix/include/shellmatch/${path})
      message(FATAL_ERROR "${header} includes ${path}, which is not installed")
    elseif(path MATCHES "[/.]" AND NOT include MATCHES "\"" AND NOT path MATCHES "^((Eigen|fmt)/|immintrin\\.h$)")
      message(FATAL_ERROR "${header} includes ${path} of another library")
    endif()
  endforeach()
endforeach()
file(GLOB targets ${WORK_DIR}/prefix/lib*/cmake/shellmatch/*.cmake ${WORK_DIR}/prefix/lib/*/cmake/shellmatch/*.cmake)
foreach(file ${targets})
  file(READ ${file} text)
  if(text MATCHES "VTK::|CGAL::|embree|CAIRO|-march=native")
    message(FATAL_ERROR "${file} asks for '${CMAKE_MATCH_0}' of those who use the package")
  endif()
endforeach()

run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${WORK_DIR}/prefix --component development)
run(${CMAKE_COMMAND} -S ${WORK_DIR}/prefix/share/doc/shellmatch/docs/examples -B ${WORK_DIR}/build-examples -G ${GENERATOR}
    -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_PREFIX_PATH=${WORK_DIR}/prefix ${flags})
run(${CMAKE_COMMAND} --build ${WORK_DIR}/build-examples)
run(${CMAKE_CTEST_COMMAND} --test-dir ${WORK_DIR}/build-examples --output-on-failure)
run(${WORK_DIR}/prefix/bin/shellmatch --help)
