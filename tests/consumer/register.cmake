# The test "consumer": the installed package works in a project of its own. Sanitized libraries
# would need a sanitized consumer, so it is not for that build.

if(NOT STILLPOINT_SANITIZE)
  add_test(NAME consumer
    COMMAND "${CMAKE_COMMAND}"
      "-DBUILD_DIR=${PROJECT_BINARY_DIR}"
      "-DWORK_DIR=${PROJECT_BINARY_DIR}/consumer"
      "-DGENERATOR=${CMAKE_GENERATOR}"
      "-DCOMPILER=${CMAKE_CXX_COMPILER}"
      -P "${CMAKE_CURRENT_LIST_DIR}/run.cmake")
endif()
