# stillpoint_room(NAME SOURCES FILE... [PUBLIC LIBRARY...] [PRIVATE LIBRARY...] [PRINTS]): a room of the house, the
# static library stillpoint_NAME or stillpoint::NAME. Its headers stand in include/, what nobody else sees in src/,
# from where its files name it: "way/room.hpp". It sees the rooms and packages that it names and no others. A room
# that only PRINTS is compiled at -Os: it is smaller, and nobody waits for it. There GCC sees optionals without a value
# read where they are not.
function(stillpoint_room name)
  cmake_parse_arguments(PARSE_ARGV 1 arg PRINTS "" "SOURCES;PUBLIC;PRIVATE")
  set(target stillpoint_${name})
  if(STILLPOINT_LEFT_OUT)
    list(FILTER arg_SOURCES EXCLUDE REGEX "^(${STILLPOINT_LEFT_OUT})\\.cpp$")
  endif()
  add_library(${target} STATIC ${arg_SOURCES})
  add_library(stillpoint::${name} ALIAS ${target})
  target_include_directories(${target} PUBLIC
    $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
    PRIVATE src)
  target_link_libraries(${target}
    PUBLIC ${arg_PUBLIC}
    PRIVATE ${arg_PRIVATE} $<BUILD_INTERFACE:stillpoint_build_flags>)
  if(arg_PRINTS)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-Os>
      $<$<AND:$<CONFIG:Release>,$<CXX_COMPILER_ID:GNU>>:-Wno-maybe-uninitialized>)
  endif()
endfunction()
