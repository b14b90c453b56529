# facenav_add_kernel(NAME src/a_kernel [OPTIONS flags of both files])
# Adds a_kernel_base.cpp and a_kernel_avx2.cpp to the target facenav_<folder of this CMakeLists.txt>: inner loops
# for two instruction sets, chosen at run time (facenav/core/simd.h). Both get -O3 in every build type but
# Debug: their loops are written for the vectoriser. If the compiler has no AVX2, the second file is
# compiled as the first and never chosen.
include(CheckCXXCompilerFlag)
check_cxx_compiler_flag("-mavx2 -mfma" FACENAV_HAS_AVX2_FLAG)
set(FACENAV_OPTIMISED "$<$<NOT:$<CONFIG:Debug>>:-O3>")
function(facenav_add_kernel)
  cmake_parse_arguments(K "" "NAME" "OPTIONS" ${ARGN})
  get_filename_component(module ${CMAKE_CURRENT_SOURCE_DIR} NAME)
  target_sources(facenav_${module} PRIVATE ${K_NAME}_base.cpp ${K_NAME}_avx2.cpp)
  set(avx2 "")
  if(FACENAV_HAS_AVX2_FLAG)
    set(avx2 -mavx2 -mfma)
  endif()
  # No precompiled header: it would bring inline functions into the AVX2 file.
  set_source_files_properties(${K_NAME}_base.cpp ${K_NAME}_avx2.cpp PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
  set_source_files_properties(${K_NAME}_base.cpp PROPERTIES COMPILE_OPTIONS "${FACENAV_OPTIMISED};${K_OPTIONS}")
  set_source_files_properties(${K_NAME}_avx2.cpp PROPERTIES COMPILE_OPTIONS "${FACENAV_OPTIMISED};${K_OPTIONS};${avx2}")
endfunction()
