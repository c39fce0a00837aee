# Installs BUILD_DIR into a fresh prefix under WORK_DIR, then configures, builds and runs the
# project beside this file against that prefix alone, by find_package and by pkg-config.
#   cmake -DBUILD_DIR=... -DWORK_DIR=... -DGENERATOR=... -DCOMPILER=... -P run.cmake

file(REMOVE_RECURSE "${WORK_DIR}")

function(step)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

step("${CMAKE_COMMAND}" --install "${BUILD_DIR}" --prefix "${WORK_DIR}/prefix")
step("${CMAKE_COMMAND}" -S "${CMAKE_CURRENT_LIST_DIR}" -B "${WORK_DIR}/build" -G "${GENERATOR}"
     "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DCMAKE_PREFIX_PATH=${WORK_DIR}/prefix")
step("${CMAKE_COMMAND}" --build "${WORK_DIR}/build")
step("${WORK_DIR}/build/consumer")

# The folder of the libraries has a name of the system.
file(GLOB_RECURSE module "${WORK_DIR}/prefix/*/stillpoint.pc")
cmake_path(GET module PARENT_PATH modules)
set(ENV{PKG_CONFIG_PATH} "${modules}")
execute_process(COMMAND pkg-config --cflags --libs stillpoint
  OUTPUT_VARIABLE flags OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
separate_arguments(flags UNIX_COMMAND "${flags}")
step("${COMPILER}" -std=c++20 -Wall -Wextra -Werror "${CMAKE_CURRENT_LIST_DIR}/main.cpp"
     ${flags} -o "${WORK_DIR}/by_pkg_config")
step("${WORK_DIR}/by_pkg_config")

# What the installed program comes with.
foreach(file IN ITEMS man/man1/stillpoint.1 bash-completion/completions/stillpoint
        fish/vendor_completions.d/stillpoint.fish stillpoint/schemas/scene.schema.json
        stillpoint/schemas/design-report-1.schema.json doc/stillpoint/copyright)
  if(NOT EXISTS "${WORK_DIR}/prefix/share/${file}")
    message(FATAL_ERROR "not installed: share/${file}")
  endif()
endforeach()
step("${WORK_DIR}/prefix/bin/stillpoint" design
     "${WORK_DIR}/prefix/share/doc/stillpoint/scenes/isolator.json" OUTPUT_QUIET)
