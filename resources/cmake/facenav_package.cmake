# What is installed, and the two Debian packages that CPack makes of it: facenav (component clinic) and facenav-lab.
# `./facenav.sh package` calls all of it; the man pages and other generated files come from resources/package/make_files.sh.
set(FACENAV_MAINTAINER "FaceNav developers <facenav@example.org>" CACHE STRING "who answers for the packages")
set(CMAKE_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(files ${PROJECT_SOURCE_DIR}/resources/package)
set(made ${PROJECT_BINARY_DIR}/package)
install(TARGETS facenav facenav-cli facenav-bids RUNTIME DESTINATION bin COMPONENT clinic)
if(TARGET facenav-gui)
  install(TARGETS facenav-gui RUNTIME DESTINATION bin COMPONENT clinic)
endif()
install(TARGETS facenav-lab OPTIONAL RUNTIME DESTINATION bin COMPONENT lab)
install(FILES Data/brain_prior/weights.fnbp DESTINATION share/facenav/brain_prior COMPONENT clinic)
install(FILES Data/virtual_patient/portrait.png DESTINATION share/facenav/virtual_patient COMPONENT lab)
install(FILES ${files}/facenav.desktop DESTINATION share/applications COMPONENT clinic)
install(FILES ${files}/facenav.svg DESTINATION share/icons/hicolor/scalable/apps COMPONENT clinic)
install(FILES ${files}/facenav.xml DESTINATION share/mime/packages COMPONENT clinic)
install(DIRECTORY resources/doc/ DESTINATION share/doc/facenav/manual COMPONENT clinic FILES_MATCHING PATTERN *.md)
# The manual's site with its pictures, and the PDF, where `./facenav.sh manual` made them.
install(DIRECTORY ${PROJECT_BINARY_DIR}/manual/html DESTINATION share/doc/facenav/manual COMPONENT clinic OPTIONAL)
install(FILES ${PROJECT_BINARY_DIR}/manual/facenav-manual.pdf DESTINATION share/doc/facenav/manual COMPONENT clinic OPTIONAL)
install(FILES ${files}/lintian-overrides DESTINATION share/lintian/overrides RENAME facenav COMPONENT clinic)
install(DIRECTORY ${made}/clinic/ DESTINATION share COMPONENT clinic OPTIONAL)
install(DIRECTORY ${made}/lab/ DESTINATION share COMPONENT lab OPTIONAL)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_COMPONENTS_ALL clinic lab)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGE_CONTACT "${FACENAV_MAINTAINER}")
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)  # the libraries' packages, by dpkg-shlibdeps
# Files that the programs read, by package; and what pictures without a desktop need.
set(CPACK_DEBIAN_CLINIC_PACKAGE_NAME facenav)
set(CPACK_DEBIAN_CLINIC_PACKAGE_DEPENDS "libdlib-data, mricron-data, fonts-dejavu-core")
set(CPACK_DEBIAN_CLINIC_PACKAGE_RECOMMENDS "libgl1-mesa-dri, xvfb, xauth, fonts-vlgothic, qttranslations5-l10n")
set(CPACK_DEBIAN_CLINIC_PACKAGE_SUGGESTS facenav-lab)
set(CPACK_COMPONENT_CLINIC_DESCRIPTION "markerless neuronavigation for rTMS
FaceNav brings a TMS coil to a place on the patient's cortex. Two ordinary
cameras see the face and the coil; nothing is fixed to the head.
.
It prepares a scan, plans targets, aligns the scan to the face, guides the
coil, and reports the session. It is not a medical device: it is for
research and development.")
set(CPACK_DEBIAN_LAB_PACKAGE_NAME facenav-lab)
set(CPACK_DEBIAN_LAB_PACKAGE_DEPENDS "facenav (= ${PROJECT_VERSION}), opencv-data, libdlib-data")
set(CPACK_COMPONENT_LAB_DESCRIPTION "virtual treatment room and evaluation for FaceNav
The laboratory of FaceNav: it renders recordings with exact truth, measures
the accuracy of every method, and runs the demo on a virtual patient.
.
No clinic needs it. It adds the verbs simulate, evaluate and demo.")
include(CPack)
