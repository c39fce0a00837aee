# Installs BUILD_DIR for a prefix of its own, as a packager does: below DESTDIR, so that the tree
# does not stand where it was installed for. Then uses it there.
#   cmake -DBUILD_DIR=... -DWORK_DIR=... -DGENERATOR=... -DCOMPILER=... -P run.cmake

file(REMOVE_RECURSE "${WORK_DIR}")

set(ENV{DESTDIR} "${WORK_DIR}/stage")
execute_process(COMMAND "${CMAKE_COMMAND}" --install "${BUILD_DIR}" --prefix /opt/stillpoint
  COMMAND_ERROR_IS_FATAL ANY)
unset(ENV{DESTDIR})

set(PREFIX "${WORK_DIR}/stage/opt/stillpoint")
include("${CMAKE_CURRENT_LIST_DIR}/use.cmake")

# What the installed program comes with.
foreach(file IN ITEMS man/man1/stillpoint.1 bash-completion/completions/stillpoint
        fish/vendor_completions.d/stillpoint.fish stillpoint/schemas/scene.schema.json
        stillpoint/schemas/design-report-2.schema.json doc/stillpoint/copyright)
  if(NOT EXISTS "${PREFIX}/share/${file}")
    message(FATAL_ERROR "not installed: share/${file}")
  endif()
endforeach()
