# stillpoint_build_flags: the compiler flags of stillpoint's own code.
#
# They serve the build only and are not exported. Link them privately and wrapped:
#   target_link_libraries(TARGET PRIVATE $<BUILD_INTERFACE:stillpoint_build_flags>)

add_library(stillpoint_build_flags INTERFACE)

target_compile_options(stillpoint_build_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow
  $<$<BOOL:${STILLPOINT_WERROR}>:-Werror>)

# GCC 12 warns of overlaps and overflows in "text" + std::string that do not exist (GCC bug 105651).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(stillpoint_build_flags INTERFACE
    -Wno-restrict -Wno-stringop-overflow -Wno-array-bounds)
endif()

# When much is compiled at once, GCC spends a tenth of its time collecting garbage: starting at 512 MB is
# early enough.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_UNITY_BUILD)
  target_compile_options(stillpoint_build_flags INTERFACE --param=ggc-min-heapsize=524288)
endif()

# Functions that a program does not call are left out of it, even if many files are compiled as one.
target_compile_options(stillpoint_build_flags INTERFACE -ffunction-sections -fdata-sections)

# Position-independent code must not cost speed: nobody should replace our functions at run time.
target_compile_options(stillpoint_build_flags INTERFACE -fno-semantic-interposition)

# a*b+c is rounded twice on every machine: a fused multiply-add would change the last digits
# from one processor to the next.
target_compile_options(stillpoint_build_flags INTERFACE -ffp-contract=off)

if(STILLPOINT_SANITIZE)
  # The first finding ends the program, so that a test cannot ignore it.
  set(sanitizers -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  if(STILLPOINT_BUILD_FUZZERS)
    list(APPEND sanitizers -fsanitize=fuzzer-no-link)
  endif()
  # A target with STILLPOINT_NOT_SANITIZED is only linked with what is sanitized.
  target_compile_options(stillpoint_build_flags INTERFACE
    "$<$<NOT:$<BOOL:$<TARGET_PROPERTY:STILLPOINT_NOT_SANITIZED>>>:${sanitizers}>")
  # GCC asks these two at every access to a member, a third of all it compiles. What reads or writes through null ends
  # under the address sanitizer anyway, and clang, which makes the fuzzers, asks both of what they run.
  target_compile_options(stillpoint_build_flags INTERFACE
    $<$<AND:$<CXX_COMPILER_ID:GNU>,$<NOT:$<BOOL:$<TARGET_PROPERTY:STILLPOINT_NOT_FUZZED>>>>:-fno-sanitize=null,alignment>)
  # Instrumented code confuses GCC's data flow: <regex> alone gives a dozen false reports.
  target_compile_options(stillpoint_build_flags INTERFACE
    $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  target_link_options(stillpoint_build_flags INTERFACE ${sanitizers})
  target_compile_definitions(stillpoint_build_flags INTERFACE _GLIBCXX_ASSERTIONS
    EIGEN_MALLOC_ALREADY_ALIGNED=0)  # Eigen's choice where it is instrumented, so everywhere
endif()
