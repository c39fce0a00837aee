# stillpoint_room(NAME SOURCES FILE... [PUBLIC LIBRARY...] [PRIVATE LIBRARY...] [PRINTS]): a room of the house, the
# static library stillpoint_NAME or stillpoint::NAME. Its headers stand in include/, what nobody else sees in src/,
# from where its files name it: "way/room.hpp". It sees the rooms and packages that it names and no others. A room
# that only PRINTS is compiled at -O1: the compiler takes a quarter less time, and nobody waits for it.
function(stillpoint_room name)
  cmake_parse_arguments(PARSE_ARGV 1 arg PRINTS "" "SOURCES;PUBLIC;PRIVATE")
  set(target stillpoint_${name})
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
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
  endif()
endfunction()
