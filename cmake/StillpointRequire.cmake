# stillpoint_require(DEBIAN_PACKAGES NAME ARGS...): find_package(NAME ARGS...), or if that fails a
# message that says how to get the package.

function(stillpoint_require debian_packages name)
  find_package(${name} ${ARGN} QUIET)
  if(NOT ${name}_FOUND)
    list(REMOVE_ITEM ARGN CONFIG MODULE COMPONENTS)
    list(JOIN ARGN " " details)
    message(FATAL_ERROR
      "stillpoint needs ${name} ${details}, which was not found.\n"
      "On Debian or Ubuntu, ./dev run and ./dev test install what they need. By hand:\n"
      "  apt-get install ${debian_packages}\n")
  endif()
endfunction()
