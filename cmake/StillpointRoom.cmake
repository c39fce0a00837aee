# stillpoint_room(NAME SOURCES FILE... [SMALL FILE...] [PUBLIC LIBRARY...] [PRIVATE LIBRARY...] [PRINTS]): a room of the
# house, the static library stillpoint_NAME or stillpoint::NAME. Its public headers are in include/, its private ones
# in src/, which its files include from there: "way/room.hpp". It sees only the rooms and packages that it names.
# Code that is not critical for speed is compiled at -Os: the files of SMALL, as the objects stillpoint_NAME_small, and all of a room
# that only PRINTS. This makes the program and the Python module smaller.
#
# What the page is made of must compile with the C++ library of Emscripten, which lacks parts of C++20. With
# STILLPOINT_PAGE_LIBRARY, the folder of its headers, the compile database says so, and clang-tidy finds what is missing.
function(stillpoint_room name)
  cmake_parse_arguments(PARSE_ARGV 1 arg PRINTS "" "SOURCES;SMALL;PUBLIC;PRIVATE")
  set(target stillpoint_${name})
  set(parts ${target})
  if(STILLPOINT_ONLY_READ)
    list(APPEND arg_SOURCES ${arg_SMALL})  # what takes longest is the headers
    set(arg_SMALL "")
  endif()
  if(STILLPOINT_LEFT_OUT)
    set(left_out ${arg_SOURCES} ${arg_SMALL})
    list(FILTER left_out INCLUDE REGEX ${STILLPOINT_LEFT_OUT})
    list(FILTER arg_SOURCES EXCLUDE REGEX ${STILLPOINT_LEFT_OUT})
    list(FILTER arg_SMALL EXCLUDE REGEX ${STILLPOINT_LEFT_OUT})
  endif()
  add_library(${target} STATIC ${arg_SOURCES})
  if(arg_SMALL)
    list(APPEND parts ${target}_small)
    add_library(${target}_small OBJECT ${arg_SMALL})
    stillpoint_small(${target}_small)
    target_sources(${target} PRIVATE $<TARGET_OBJECTS:${target}_small>)
  endif()
  if(arg_PRINTS)
    stillpoint_small(${target})
    # Instrumented, -O1 takes the compiler longer than it saves when the tests run.
    target_compile_options(${target} PRIVATE
      $<$<AND:$<BOOL:${STILLPOINT_SANITIZE}>,$<CXX_COMPILER_ID:GNU>>:-O0>)
  endif()
  add_library(stillpoint::${name} ALIAS ${target})
  if(STILLPOINT_PAGE_LIBRARY)
    foreach(part IN LISTS parts)
      target_compile_options(${part} PRIVATE
        -nostdinc++ -isystem${PROJECT_SOURCE_DIR}/cli/explorer/engine/standard -isystem${STILLPOINT_PAGE_LIBRARY})
    endforeach()
    if(left_out)
      list(APPEND parts ${target}_left_out)
      add_library(${target}_left_out OBJECT ${left_out})
      target_include_directories(${target}_left_out PRIVATE $<TARGET_PROPERTY:${target},INCLUDE_DIRECTORIES>)
    endif()
  endif()
  foreach(part IN LISTS parts)
    target_include_directories(${part} PUBLIC
      $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>
      $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
      PRIVATE src)
    target_link_libraries(${part}
      PUBLIC ${arg_PUBLIC}
      PRIVATE ${arg_PRIVATE} $<BUILD_INTERFACE:stillpoint_build_flags>)
  endforeach()
endfunction()

# Of a Release build. At -Os GCC warns of reads of empty optionals that do not happen.
function(stillpoint_small target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-Os>
    $<$<AND:$<CONFIG:Release>,$<CXX_COMPILER_ID:GNU>>:-Wno-maybe-uninitialized>)
endfunction()
