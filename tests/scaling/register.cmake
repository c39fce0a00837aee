# The scripts of docs/scaling, each with its engine, where that is installed; else the test is skipped.
if(NOT STILLPOINT_SANITIZE)
  foreach(engine IN ITEMS parallel openmpi mpich slurm)
    add_test(NAME scaling_${engine}
      COMMAND sh "${CMAKE_CURRENT_LIST_DIR}/run.sh" ${engine} $<TARGET_FILE:stillpoint>
        "${PROJECT_SOURCE_DIR}/docs/scaling")
    set_tests_properties(scaling_${engine} PROPERTIES SKIP_RETURN_CODE 77 TIMEOUT 300)
  endforeach()
endif()
