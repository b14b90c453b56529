# Precompiled headers: one for all modules, one for all test programs, one for the command line tool. Parsing
# these headers takes most of the time of a small file. A file still includes what it uses: the presets of
# `./facenav.sh check` build without precompiled headers and report a missing include.
option(FACENAV_PRECOMPILED "precompile the headers that most files read" ON)
set(FACENAV_COMMON_HEADERS
  <algorithm> <array> <atomic> <chrono> <cmath> <cstdint> <deque> <filesystem> <fstream> <functional> <map> <memory> <mutex> <optional>
  <random> <set> <sstream> <stdexcept> <string> <string_view> <thread> <utility> <variant> <vector> <Eigen/Dense> <opencv2/imgproc.hpp>)
set(FACENAV_COMMON_LIBS Eigen3::Eigen opencv_imgproc)
set(FACENAV_TEST_HEADERS ${FACENAV_COMMON_HEADERS} <gtest/gtest.h> <gmock/gmock.h>)
# Qt's programs are position independent code and cannot use the header of the modules.
set(FACENAV_QT_HEADERS ${FACENAV_COMMON_HEADERS} <QtWidgets/QtWidgets>)

# facenav_add_headers(name headers LIBS ..): adds the target `name`, whose precompiled header other targets use.
function(facenav_add_headers name)
  cmake_parse_arguments(H "" "" "HEADERS;LIBS" ${ARGN})
  set(source ${PROJECT_BINARY_DIR}/${name}.cpp)
  if(NOT EXISTS ${source})
    file(WRITE ${source} "// Carries a precompiled header.\n")
  endif()
  add_library(${name} OBJECT ${source})
  target_link_libraries(${name} PRIVATE ${H_LIBS} facenav_warnings)
  target_precompile_headers(${name} PRIVATE ${H_HEADERS})
endfunction()

if(FACENAV_PRECOMPILED)
  facenav_add_headers(facenav_module_headers HEADERS ${FACENAV_COMMON_HEADERS} LIBS ${FACENAV_COMMON_LIBS})
  facenav_add_headers(facenav_cold_headers HEADERS ${FACENAV_COMMON_HEADERS} LIBS ${FACENAV_COMMON_LIBS})
  facenav_compile_cold(facenav_cold_headers)
  if(FACENAV_BUILD_TESTS OR FACENAV_BUILD_BENCHMARKS)
    facenav_add_headers(facenav_test_headers HEADERS ${FACENAV_TEST_HEADERS} LIBS ${FACENAV_COMMON_LIBS} GTest::gmock)
    target_compile_options(facenav_test_headers PRIVATE ${FACENAV_TEST_OPTIMISATION})  # as facenav_add_test
  endif()
endif()

# facenav_use_headers(target facenav_module_headers): uses the precompiled header of another target.
function(facenav_use_headers target from)
  if(FACENAV_PRECOMPILED)
    target_precompile_headers(${target} REUSE_FROM ${from})
  endif()
endfunction()
