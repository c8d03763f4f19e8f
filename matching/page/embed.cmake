# Writes the page with its style and its program as a C++ source, which defines the constant NAME of HEADER:
# cmake -D PAGE= -D PROGRAM= -D STYLE= -D HEADER= -D NAME= -D OUTPUT= -P embed.cmake
file(READ ${PAGE} page)
file(READ ${PROGRAM} program)
file(READ ${STYLE} style)
foreach(part style program)
  string(FIND "${${part}}" "</${part}" inside)
  if(NOT inside EQUAL -1 OR "${${part}}" MATCHES "</script|<!--")
    message(FATAL_ERROR "the ${part} of the report would end its own element")
  endif()
  string(FIND "${page}" "/* ${part} */" at)
  if(at EQUAL -1)
    message(FATAL_ERROR "${PAGE}: no place for the ${part}")
  endif()
  string(LENGTH "/* ${part} */" length)
  math(EXPR after "${at} + ${length}")
  string(SUBSTRING "${page}" 0 ${at} head)
  string(SUBSTRING "${page}" ${after} -1 tail)
  set(page "${head}${${part}}${tail}")
endforeach()
string(FIND "${page}" ")__page__\"" inside)
if(NOT inside EQUAL -1)
  message(FATAL_ERROR "the report's page would end its own string")
endif()
file(WRITE ${OUTPUT} "// Made from matching/page/ by matching/page/embed.cmake.
#include \"${HEADER}\"

const std::string_view shellmatch::${NAME} = R\"__page__(${page})__page__\";
")
