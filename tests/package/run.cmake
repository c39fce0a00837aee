# Packs BUILD_DIR into WORK_DIR, looks into the two packages, then uses them unpacked.
#   cmake -DBUILD_DIR=... -DWORK_DIR=... -DGENERATOR=... -DCOMPILER=... -P run.cmake

file(REMOVE_RECURSE "${WORK_DIR}")
cmake_path(GET CMAKE_COMMAND PARENT_PATH tools)
execute_process(COMMAND "${tools}/cpack" --config "${BUILD_DIR}/CPackConfig.cmake" -B "${WORK_DIR}"
  COMMAND_ERROR_IS_FATAL ANY)

# check_package(NAME DEPENDS PATTERNS...): the one package NAME depends on what DEPENDS matches, has
# a file for each pattern, and all it has belongs to root below /usr and can be read by all.
function(check_package name depends)
  file(GLOB package "${WORK_DIR}/${name}_*.deb")
  execute_process(COMMAND dpkg-deb --field "${package}" Package Maintainer Depends Description
    OUTPUT_VARIABLE fields COMMAND_ERROR_IS_FATAL ANY)
  foreach(pattern IN ITEMS "Package: ${name}\n" "Maintainer: [^\n]+ <[^\n]+@[^\n]+>\n"
          "Depends: [^\n]*${depends}" "Description: [^\n]+\n [^\n]+")
    if(NOT fields MATCHES "${pattern}")
      message(SEND_ERROR "${name}: nothing like \"${pattern}\" in\n${fields}")
    endif()
  endforeach()

  execute_process(COMMAND dpkg-deb --contents "${package}"
    OUTPUT_VARIABLE contents COMMAND_ERROR_IS_FATAL ANY)
  foreach(pattern IN LISTS ARGN ITEMS doc/${name}/copyright doc/${name}/changelog.gz
          doc/${name}/changelog.Debian.gz)
    if(NOT contents MATCHES "/${pattern}\n")
      message(SEND_ERROR "${name}: no file ${pattern} in\n${contents}")
    endif()
  endforeach()
  string(REGEX MATCHALL "[^\n]+" entries "${contents}")
  list(FILTER entries EXCLUDE REGEX "^drwxr-xr-x root/root .* \\./(usr/.*)?$")
  list(FILTER entries EXCLUDE REGEX "^-rw-r--r-- root/root .* \\./usr/.*[^/]$")
  list(FILTER entries EXCLUDE REGEX "^-rwxr-xr-x root/root .* \\./usr/bin/stillpoint$")
  if(entries)
    list(JOIN entries "\n" entries)
    message(SEND_ERROR "${name}: of another owner, mode or place than a package has:\n${entries}")
  endif()

  execute_process(COMMAND dpkg-deb --extract "${package}" "${WORK_DIR}/root"
    COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# The program's libraries are found by what it is linked with, the others are named.
check_package(stillpoint "libnlopt[^\n]*libstdc"
  bin/stillpoint man/man1/stillpoint.1.gz
  bash-completion/completions/stillpoint zsh/vendor-completions/_stillpoint
  fish/vendor_completions.d/stillpoint.fish
  stillpoint/schemas/scene.schema.json stillpoint/schemas/design-report-2.schema.json
  doc/stillpoint/scenes/isolator.json doc/stillpoint/records/strong_motion.AT2)
check_package(libstillpoint-dev
  "libeigen3-dev[^\n]*libfmt-dev .>= [0-9]+.,[^\n]*libhwy-dev[^\n]*libnlopt-cxx-dev"
  include/stillpoint/core/free_motion.hpp include/stillpoint/design/design.hpp
  include/stillpoint/records/record_file.hpp include/stillpoint/sweep/run.hpp
  libstillpoint_motion.a libstillpoint_records.a libstillpoint_integrators.a libstillpoint_damper.a libstillpoint_sweep.a
  cmake/stillpoint/stillpointConfig.cmake cmake/stillpoint/FindNLopt.cmake
  pkgconfig/stillpoint.pc pkgconfig/stillpoint-core.pc)

# Each scene works, whatever the working directory: all that it names is beside it.
file(GLOB scenes "${WORK_DIR}/root/usr/share/doc/stillpoint/scenes/*.json")
foreach(scene IN LISTS scenes)
  cmake_path(GET scene STEM name)
  set(command design)
  if(name STREQUAL "spectrum")
    set(command spectrum)
  endif()
  execute_process(COMMAND "${WORK_DIR}/root/usr/bin/stillpoint" ${command} "${scene}" --json
    WORKING_DIRECTORY "${WORK_DIR}" RESULT_VARIABLE code OUTPUT_QUIET ERROR_VARIABLE said)
  if(NOT code EQUAL 0 AND NOT (name STREQUAL "infeasible" AND code EQUAL 3))
    message(SEND_ERROR "${command} ${scene} ends with ${code}: ${said}")
  endif()
endforeach()

# The module, where it was built: the interpreter that it depends on finds it.
file(GLOB module "${WORK_DIR}/python3-stillpoint_*.deb")
if(module)
  check_package(python3-stillpoint "python3 .>= 3[^\n]*python3-numpy[^\n]*libnlopt"
    lib/python3/dist-packages/stillpoint/__init__.py lib/python3/dist-packages/stillpoint/__init__.pyi
    lib/python3/dist-packages/stillpoint/py.typed
    "lib/python3/dist-packages/stillpoint/_stillpoint[^/]*.so")
  execute_process(
    COMMAND "${CMAKE_COMMAND}" -E env "PYTHONPATH=${WORK_DIR}/root/usr/lib/python3/dist-packages"
      /usr/bin/python3 -B -c "import stillpoint; print(stillpoint.design(v0=1, p=1, beta=0.9).design.f)"
    OUTPUT_VARIABLE f COMMAND_ERROR_IS_FATAL ANY)
  if(NOT f MATCHES "^0[.]2593")
    message(SEND_ERROR "the module designs f = ${f}")
  endif()
endif()

execute_process(COMMAND file "${WORK_DIR}/root/usr/bin/stillpoint" OUTPUT_VARIABLE kind)
if(NOT kind MATCHES ", stripped")
  message(SEND_ERROR "not stripped: ${kind}")
endif()

set(PREFIX "${WORK_DIR}/root/usr")
include("${CMAKE_CURRENT_LIST_DIR}/../consumer/use.cmake")
