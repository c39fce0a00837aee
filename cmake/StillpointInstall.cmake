# Installs its parts. "program": the program, its manual page, completions, schemas, scenes and records.
# "development": the libraries of core and design, their headers, the CMake package "stillpoint" with
# the targets stillpoint::core and stillpoint::design, and the same for pkg-config. "python", where it is
# built: the package for import.

include(CMakePackageConfigHelpers)

# The program.
set(generated_dir "${PROJECT_BINARY_DIR}/generated")
# Debian's zsh looks for the completions of packages in vendor-completions.
if(CMAKE_INSTALL_PREFIX STREQUAL "/usr")
  set(zsh_dir "${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions")
else()
  set(zsh_dir "${CMAKE_INSTALL_DATADIR}/zsh/site-functions")
endif()

install(TARGETS stillpoint COMPONENT program)
install(FILES "${generated_dir}/stillpoint.1"
        DESTINATION "${CMAKE_INSTALL_MANDIR}/man1" COMPONENT program)
install(FILES "${generated_dir}/stillpoint.bash"
        DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions"
        RENAME stillpoint COMPONENT program)
install(FILES "${generated_dir}/_stillpoint" DESTINATION "${zsh_dir}" COMPONENT program)
install(FILES "${generated_dir}/stillpoint.fish"
        DESTINATION "${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d" COMPONENT program)
install(DIRECTORY data/schemas/ DESTINATION "${CMAKE_INSTALL_DATADIR}/stillpoint/schemas"
        COMPONENT program FILES_MATCHING PATTERN "*.schema.json")
# The page, where ./dev explorer has made it.
install(FILES "${PROJECT_SOURCE_DIR}/build/explorer/stillpoint.html"
        DESTINATION "${CMAKE_INSTALL_DATADIR}/stillpoint" COMPONENT program OPTIONAL)
# The scenes name the records beside them.
install(DIRECTORY data/scenes data/records DESTINATION "${CMAKE_INSTALL_DOCDIR}" COMPONENT program
        PATTERN make_records.py EXCLUDE)
install(FILES LICENSE DESTINATION "${CMAKE_INSTALL_DOCDIR}" RENAME copyright COMPONENT program)

# The libraries. The headers are C++20, so the code that includes them must be too.
set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/stillpoint")
target_compile_features(stillpoint_motion PUBLIC cxx_std_20)

set(libraries motion records core integrators damper sweep design)
foreach(library IN LISTS libraries)
  set_target_properties(stillpoint_${library} PROPERTIES EXPORT_NAME ${library})
endforeach()
list(TRANSFORM libraries PREPEND stillpoint_)

install(TARGETS ${libraries}
        EXPORT stillpointTargets
        COMPONENT development
        INCLUDES DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
install(DIRECTORY core/motion/include/ core/records/include/ design/damper/include/ design/sweep/include/
        DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}"
        COMPONENT development
        FILES_MATCHING PATTERN "*.hpp")
install(FILES LICENSE DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/libstillpoint-dev"
        RENAME copyright COMPONENT development)

install(EXPORT stillpointTargets NAMESPACE stillpoint:: DESTINATION "${package_dir}"
        COMPONENT development)

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
  DESTINATION "${package_dir}" COMPONENT development)

# For pkg-config. The prefix is found from the location of the file, so that everything can be moved.
# The libraries are static: their users link what they use.
file(RELATIVE_PATH pc_to_prefix "/prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/prefix")
string(REGEX REPLACE "/$" "" pc_to_prefix "${pc_to_prefix}")
cmake_path(GET NLopt_LIBRARY STEM pc_nlopt)
string(REGEX REPLACE "^lib" "" pc_nlopt "${pc_nlopt}")
foreach(module IN ITEMS stillpoint-core stillpoint)
  configure_file("${PROJECT_SOURCE_DIR}/cmake/${module}.pc.in"
                 "${PROJECT_BINARY_DIR}/${module}.pc" @ONLY)
  install(FILES "${PROJECT_BINARY_DIR}/${module}.pc"
          DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig" COMPONENT development)
endforeach()

# Where Python looks: Debian's own packages have a folder for all versions, what is installed by hand one
# for each.
if(STILLPOINT_BUILD_PYTHON)
  set(version "${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}")
  execute_process(COMMAND "${Python_EXECUTABLE}" -c
      "import sysconfig; print('deb_system' in sysconfig.get_scheme_names())"
    OUTPUT_VARIABLE of_debian OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  if(NOT of_debian STREQUAL "True")
    set(python_dir "lib/python${version}/site-packages")
  elseif(CMAKE_INSTALL_PREFIX STREQUAL "/usr")
    set(python_dir "lib/python3/dist-packages")
  else()
    set(python_dir "lib/python${version}/dist-packages")
  endif()
  if(NOT STILLPOINT_PYTHON_DIR)  # below the prefix
    set(STILLPOINT_PYTHON_DIR "${python_dir}")
  endif()
  install(TARGETS stillpoint_python
          DESTINATION "${STILLPOINT_PYTHON_DIR}/stillpoint" COMPONENT python)
  install(FILES cli/python/stillpoint/__init__.py cli/python/stillpoint/py.typed
                "${PROJECT_BINARY_DIR}/cli/python/stillpoint/__init__.pyi"
          DESTINATION "${STILLPOINT_PYTHON_DIR}/stillpoint" COMPONENT python)
  install(FILES LICENSE DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/python3-stillpoint"
          RENAME copyright COMPONENT python)
endif()
