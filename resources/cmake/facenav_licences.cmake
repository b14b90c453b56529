# facenav_licence_table(OUTPUT): writes the source of modules/base/core/src/licence_table.h from resources/licences/parts.txt,
# with the installed version of each Debian package. Where there is no dpkg the versions stay empty. A row whose package has a *
# is left out if the package is not installed.
function(facenav_licence_table output)
  set(table ${PROJECT_SOURCE_DIR}/resources/licences/parts.txt)
  set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${table})
  file(STRINGS ${table} rows REGEX "^[^#]")
  find_program(FACENAV_DPKG_QUERY dpkg-query)
  set(text "")
  foreach(row ${rows})
    string(REGEX MATCH "\\| *(\\*?)([a-z0-9.+-]+) *\\|[^|]*$" ignored "${row}")
    set(is_optional "${CMAKE_MATCH_1}")
    set(package "${CMAKE_MATCH_2}")
    set(version "")
    if(FACENAV_DPKG_QUERY AND package)
      execute_process(COMMAND ${FACENAV_DPKG_QUERY} -W "-f=\${Version}\\n" ${package} OUTPUT_VARIABLE version ERROR_QUIET)
      string(REGEX REPLACE "\n.*" "" version "${version}")
    endif()
    if(version OR NOT is_optional OR NOT FACENAV_DPKG_QUERY)
      string(REPLACE "*" "" row "${row}")
      string(APPEND text "${row} | ${version}\n")
    endif()
  endforeach()
  file(CONFIGURE OUTPUT ${output} @ONLY CONTENT [[// Written by facenav_licences.cmake.
#include "licence_table.h"
namespace facenav {
inline namespace core {
const char* licenceTable() { return R"table(@text@)table"; }
}  // namespace core
}  // namespace facenav
]])
endfunction()
