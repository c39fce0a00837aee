# The packages for Emscripten's compiler, which does not see /usr: the headers of header-only packages, and NLopt, built from the source of Debian's package, whose folder is STILLPOINT_NLOPT_SOURCE.

# As small as possible: the page contains it. Everything is linked at once, so no code need be independent of its position.
set(CMAKE_CXX_FLAGS_MINSIZEREL "-Oz -DNDEBUG")
set(CMAKE_C_FLAGS_MINSIZEREL "-Oz -DNDEBUG")
set(CMAKE_POSITION_INDEPENDENT_CODE OFF)
add_compile_options(-fwasm-exceptions -Wno-unused-command-line-argument)
add_link_options(-fwasm-exceptions)

# Emscripten's tools take every folder of /usr for the machine's, so the headers stand in a folder of links.
set(host_headers "${PROJECT_BINARY_DIR}/headers")
file(MAKE_DIRECTORY "${host_headers}")
foreach(name IN ITEMS boost CLI fmt hwy nlohmann nlopt.h nlopt.hpp)
  if(NOT EXISTS "/usr/include/${name}")
    message(FATAL_ERROR "/usr/include/${name} is missing: ./dev explorer installs what it needs")
  endif()
  file(CREATE_LINK "/usr/include/${name}" "${host_headers}/${name}" SYMBOLIC)
endforeach()
file(CREATE_LINK "/usr/include/eigen3/Eigen" "${host_headers}/Eigen" SYMBOLIC)

foreach(package IN ITEMS Eigen3::Eigen fmt::fmt hwy::hwy Boost::headers nlohmann_json::nlohmann_json CLI11::CLI11
        Threads::Threads ZLIB::ZLIB)
  add_library(${package} INTERFACE IMPORTED GLOBAL)
  target_include_directories(${package} SYSTEM INTERFACE "${host_headers}")
endforeach()
target_compile_definitions(fmt::fmt INTERFACE FMT_HEADER_ONLY)

# The parts of C++20 that libc++ lacks come before its own headers.
include_directories(BEFORE SYSTEM "${PROJECT_SOURCE_DIR}/cli/explorer/engine/standard")

file(STRINGS "${STILLPOINT_NLOPT_SOURCE}/CMakeLists.txt" versions REGEX "set *\\(NLOPT_[A-Z]+_VERSION")
foreach(line IN LISTS versions)
  string(REGEX REPLACE ".*NLOPT_([A-Z]+)_VERSION *\"?([0-9]+).*" "\\1_VERSION=\\2" definition "${line}")
  list(APPEND nlopt_definitions ${definition})
endforeach()
file(WRITE "${PROJECT_BINARY_DIR}/nlopt/nlopt_config.h" "")
# Those that a design can ask for; engine/library.js says what happens to the rest. The headers are those of all.
set(algorithms cdirect cobyla crs mma neldermead slsqp)
foreach(algorithm IN ITEMS ${algorithms} auglag bobyqa direct esch isres luksan mlsl newuoa praxis)
  list(APPEND nlopt_folders "${STILLPOINT_NLOPT_SOURCE}/src/algs/${algorithm}")
endforeach()
file(GLOB nlopt_files "${STILLPOINT_NLOPT_SOURCE}/src/api/*.c" "${STILLPOINT_NLOPT_SOURCE}/src/util/*.c")
foreach(algorithm IN LISTS algorithms)
  file(GLOB files "${STILLPOINT_NLOPT_SOURCE}/src/algs/${algorithm}/*.c")
  list(APPEND nlopt_files ${files})
endforeach()
list(FILTER nlopt_files EXCLUDE REGEX "test\\.c$|(getopt|f77api|sobolseq)\\.c$")
enable_language(C)
add_library(stillpoint_nlopt STATIC ${nlopt_files})
set_target_properties(stillpoint_nlopt PROPERTIES UNITY_BUILD OFF)
target_include_directories(stillpoint_nlopt PRIVATE "${PROJECT_BINARY_DIR}/nlopt" ${nlopt_folders}
  "${STILLPOINT_NLOPT_SOURCE}/src/api" "${STILLPOINT_NLOPT_SOURCE}/src/util" SYSTEM INTERFACE "${host_headers}")
target_compile_definitions(stillpoint_nlopt PRIVATE ${nlopt_definitions} THREADLOCAL= HAVE_COPYSIGN HAVE_ISINF HAVE_ISNAN
  HAVE_GETTIMEOFDAY HAVE_STDINT_H HAVE_SYS_TIME_H HAVE_TIME HAVE_UINT32_T HAVE_UNISTD_H TIME_WITH_SYS_TIME
  SIZEOF_UNSIGNED_INT=4 SIZEOF_UNSIGNED_LONG=4)
target_compile_options(stillpoint_nlopt PRIVATE -w)
add_library(NLopt::nlopt ALIAS stillpoint_nlopt)
