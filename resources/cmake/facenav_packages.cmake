# Third-party packages, each component by name (a bare OpenCV_LIBS or
# PCL_LIBRARIES would pull Qt and the VTK GUI into the command line).
find_package(Threads REQUIRED)
find_package(TBB REQUIRED CONFIG COMPONENTS tbb)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(spdlog REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(VTK 9.1 REQUIRED COMPONENTS
  CommonCore CommonDataModel CommonExecutionModel CommonMath CommonTransforms CommonComputationalGeometry
  FiltersCore FiltersGeneral FiltersGeometry FiltersModeling FiltersSources FiltersExtraction FiltersTexture
  ImagingCore ImagingGeneral ImagingMorphological ImagingStencil ImagingHybrid
  IOCore IOXML IOGeometry IOPLY IOImage IOLegacy
  RenderingCore RenderingOpenGL2 RenderingAnnotation RenderingFreeType InteractionStyle InteractionWidgets)
find_package(GDCM REQUIRED)
find_package(OpenCV 4.6 REQUIRED COMPONENTS core imgproc imgcodecs calib3d objdetect features2d video videoio aruco flann)
find_package(PCL 1.13 REQUIRED COMPONENTS common kdtree search filters)
find_package(dlib REQUIRED)
find_package(embree 3 REQUIRED)
# Optional: GenICam and IEEE 1394 cameras (without them they are not listed), and pulses by the sound of the coil's click.
find_package(PkgConfig)
if(PKG_CONFIG_FOUND)
  pkg_check_modules(ARAVIS IMPORTED_TARGET aravis-0.8)
  pkg_check_modules(DC1394 IMPORTED_TARGET libdc1394-2)
  pkg_check_modules(ALSA IMPORTED_TARGET alsa)
  pkg_check_modules(SNDFILE IMPORTED_TARGET sndfile)
endif()
if(FACENAV_BUILD_UI)
  find_package(VTK 9.1 REQUIRED COMPONENTS GUISupportQt)
  find_package(Qt5 5.15 REQUIRED COMPONENTS Widgets)
  if(FACENAV_BUILD_TESTS)
    find_package(Qt5 5.15 REQUIRED COMPONENTS Test)
  endif()
endif()
if(FACENAV_BUILD_TESTS OR FACENAV_BUILD_BENCHMARKS)
  find_package(GTest REQUIRED)
endif()
find_path(NIFTI_INCLUDE_DIR nifti1_io.h PATH_SUFFIXES nifti REQUIRED)
find_library(NIFTI_IO_LIBRARY niftiio REQUIRED)
find_library(NIFTI_ZNZ_LIBRARY znz REQUIRED)

add_library(facenav_nifti_io INTERFACE)
target_include_directories(facenav_nifti_io SYSTEM INTERFACE ${NIFTI_INCLUDE_DIR})
target_link_libraries(facenav_nifti_io INTERFACE ${NIFTI_IO_LIBRARY} ${NIFTI_ZNZ_LIBRARY})

add_library(facenav_warnings INTERFACE)
target_compile_options(facenav_warnings INTERFACE -Wall -Wextra -Wshadow -Wnon-virtual-dtor)
if(FACENAV_WERROR)
  target_compile_options(facenav_warnings INTERFACE -Werror)
endif()
