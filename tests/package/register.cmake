# The test "package": what cpack makes is what Debian asks of a package, and it works. Only where
# Debian's tools are.

find_program(STILLPOINT_SHLIBDEPS dpkg-shlibdeps)
find_program(STILLPOINT_FILE file)
mark_as_advanced(STILLPOINT_SHLIBDEPS STILLPOINT_FILE)
if(STILLPOINT_SHLIBDEPS AND STILLPOINT_FILE AND NOT STILLPOINT_SANITIZE)
  add_test(NAME package
    COMMAND "${CMAKE_COMMAND}"
      "-DBUILD_DIR=${PROJECT_BINARY_DIR}"
      "-DWORK_DIR=${PROJECT_BINARY_DIR}/packages"
      "-DGENERATOR=${CMAKE_GENERATOR}"
      "-DCOMPILER=${CMAKE_CXX_COMPILER}"
      -P "${CMAKE_CURRENT_LIST_DIR}/run.cmake")
endif()
