# Runs at every build: writes the revision of the sources in SOURCE_DIR to the file OUTPUT, if it has changed.
# Twelve digits in every clone: git's own choice depends on what else the clone holds.
execute_process(COMMAND git describe --always --dirty --tags --abbrev=12 WORKING_DIRECTORY ${SOURCE_DIR}
  OUTPUT_VARIABLE revision ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE RESULT_VARIABLE failed)
if(failed)
  set(revision "")
endif()
set(text "#include \"apps/studies/execution/machine.h\"\n\nstd::string shellmatch::build_revision() { return \"${revision}\"; }\n")
set(old "")
if(EXISTS ${OUTPUT})
  file(READ ${OUTPUT} old)
endif()
if(NOT text STREQUAL old)
  file(WRITE ${OUTPUT} "${text}")
endif()
