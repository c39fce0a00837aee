# Installs the program, the two libraries, their headers and the CMake package "stillpoint",
# which gives the targets stillpoint::core and stillpoint::design.

include(CMakePackageConfigHelpers)

set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/stillpoint")

# The headers are C++20: so must be whatever includes them.
target_compile_features(stillpoint_core PUBLIC cxx_std_20)

set_target_properties(stillpoint_core PROPERTIES EXPORT_NAME core)
set_target_properties(stillpoint_design PROPERTIES EXPORT_NAME design)

install(TARGETS stillpoint)
install(TARGETS stillpoint_core stillpoint_design
        EXPORT stillpointTargets
        INCLUDES DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
install(DIRECTORY core/include/ design/include/
        DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}"
        FILES_MATCHING PATTERN "*.hpp")

install(EXPORT stillpointTargets NAMESPACE stillpoint:: DESTINATION "${package_dir}")

configure_package_config_file(
  "${PROJECT_SOURCE_DIR}/cmake/stillpointConfig.cmake.in"
  "${PROJECT_BINARY_DIR}/stillpointConfig.cmake"
  INSTALL_DESTINATION "${package_dir}")
# Before 1.0 a new minor version may change the interface.
write_basic_package_version_file(
  "${PROJECT_BINARY_DIR}/stillpointConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)

install(FILES
  "${PROJECT_BINARY_DIR}/stillpointConfig.cmake"
  "${PROJECT_BINARY_DIR}/stillpointConfigVersion.cmake"
  "${PROJECT_SOURCE_DIR}/cmake/FindNLopt.cmake"
  DESTINATION "${package_dir}")

install(DIRECTORY data/schemas/ DESTINATION "${CMAKE_INSTALL_DATADIR}/stillpoint/schemas"
        FILES_MATCHING PATTERN "*.schema.json")
