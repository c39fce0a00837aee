# stillpoint_require(DEBIAN_PACKAGES NAME [LEAST VERSION] ARGS...): find_package(NAME ARGS...), or if that fails
# a message that says how to get the package. With LEAST any later version will do, also of another major one,
# which some packages refuse if find_package is asked for a version.

function(stillpoint_require debian_packages name)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "LEAST" "")
  set(arguments ${arg_UNPARSED_ARGUMENTS})
  find_package(${name} ${arguments} QUIET)
  if(NOT ${name}_FOUND OR "${${name}_VERSION}" VERSION_LESS "${arg_LEAST}")
    list(REMOVE_ITEM arguments CONFIG MODULE COMPONENTS)
    list(JOIN arguments " " details)
    message(FATAL_ERROR
      "stillpoint needs ${name} ${arg_LEAST}${details}, which was not found.\n"
      "On Debian or Ubuntu, ./dev run and ./dev test install what they need. By hand:\n"
      "  apt-get install ${debian_packages}\n")
  endif()
endfunction()
