# Included with PREFIX, the place of an installed stillpoint, and BUILD_DIR, WORK_DIR, GENERATOR,
# COMPILER.
# Configures, builds and runs the project beside this file against that prefix alone, by
# find_package and by pkg-config, then runs the program.

function(step)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# It can be moved: nothing in it names the tree it was built in.
execute_process(COMMAND grep -rlF "${BUILD_DIR}" "${PREFIX}" RESULT_VARIABLE code OUTPUT_VARIABLE named)
if(NOT code EQUAL 1)
  message(FATAL_ERROR "these name the build directory:\n${named}")
endif()

step("${CMAKE_COMMAND}" -S "${CMAKE_CURRENT_LIST_DIR}" -B "${WORK_DIR}/build" -G "${GENERATOR}"
     "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DCMAKE_PREFIX_PATH=${PREFIX}")
file(STRINGS "${WORK_DIR}/build/CMakeCache.txt" found REGEX "^stillpoint_DIR:PATH=")
string(FIND "${found}" "stillpoint_DIR:PATH=${PREFIX}/" place)
if(NOT place EQUAL 0)
  message(FATAL_ERROR "another stillpoint was found than that in ${PREFIX}: ${found}")
endif()
step("${CMAKE_COMMAND}" --build "${WORK_DIR}/build")
step("${WORK_DIR}/build/consumer")

# The folder of the libraries has a name of the system.
file(GLOB_RECURSE module "${PREFIX}/*/stillpoint.pc")
cmake_path(GET module PARENT_PATH modules)
set(ENV{PKG_CONFIG_PATH} "${modules}")
execute_process(COMMAND pkg-config --cflags --libs stillpoint
  OUTPUT_VARIABLE flags OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
separate_arguments(flags UNIX_COMMAND "${flags}")
step("${COMPILER}" -std=c++20 -Wall -Wextra -Werror "${CMAKE_CURRENT_LIST_DIR}/main.cpp"
     ${flags} -o "${WORK_DIR}/by_pkg_config")
step("${WORK_DIR}/by_pkg_config")

step("${PREFIX}/bin/stillpoint" design "${PREFIX}/share/doc/stillpoint/scenes/isolator.json"
     OUTPUT_QUIET)
