# Writes HEADER with the commit of the sources in SOURCE_DIR; empty where they are not under git. The header is
# left alone if nothing has changed, so that nothing is compiled anew.
execute_process(COMMAND git -C ${SOURCE_DIR} describe --always --dirty --abbrev=12 OUTPUT_VARIABLE commit
                OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
if(failed)
  set(commit "")
endif()
set(content "#pragma once\n\ninline constexpr const char* kSourceCommit = \"${commit}\";\n")
if(EXISTS ${HEADER})
  file(READ ${HEADER} present)
endif()
if(NOT "${present}" STREQUAL "${content}")
  file(WRITE ${HEADER} "${content}")
endif()
