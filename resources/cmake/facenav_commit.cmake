# cmake -DGIT=git -DSOURCE_DIR=dir -DOUTPUT=software_commit.cpp -P facenav_commit.cmake
# Writes the source of app/software_commit.h and, beside it, the dependency file that names the files of git that
# change with each commit and checkout. Without git, or if SOURCE_DIR is not a checkout: "unknown".
set(commit unknown)
set(depends "")

function(ask_git result)
  execute_process(COMMAND "${GIT}" -C "${SOURCE_DIR}" ${ARGN} OUTPUT_VARIABLE out ERROR_QUIET RESULT_VARIABLE failed
    OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(failed)
    set(out "")
  endif()
  set(${result} "${out}" PARENT_SCOPE)
endfunction()

if(GIT)
  ask_git(root rev-parse --show-toplevel)
  file(REAL_PATH "${SOURCE_DIR}" source_dir)
  if(root STREQUAL source_dir)
    ask_git(hash rev-parse --short HEAD)
    foreach(file HEAD logs/HEAD)
      ask_git(path rev-parse --git-path ${file})
      if(path)
        file(REAL_PATH "${path}" path BASE_DIRECTORY "${SOURCE_DIR}")
      endif()
      if(path AND EXISTS "${path}")
        string(REPLACE " " "\\ " path "${path}")
        string(APPEND depends " ${path}")
      endif()
    endforeach()
  endif()
endif()
if(hash)
  set(commit "${hash}")
endif()

file(WRITE "${OUTPUT}" "// Written by facenav_commit.cmake.
#include \"software_commit.h\"
namespace facenav::app {
const char* softwareCommit() { return \"${commit}\"; }
}  // namespace facenav::app
")
string(REPLACE " " "\\ " output "${OUTPUT}")
file(WRITE "${OUTPUT}.d" "${output}:${depends}\n")
