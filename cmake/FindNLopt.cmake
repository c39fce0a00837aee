# Finds NLopt with its C++ interface: target NLopt::nlopt.
#
# Debian ships two NLoptConfig.cmake, one of the C library and one of the C++ one, and find_package
# may find either. This module serves the build and, installed beside
# stillpointConfig.cmake, the users of the installed library. nlopt_cxx is preferred: it holds
# the algorithms written in C++ (StoGO, AGS) as well.

find_path(NLopt_INCLUDE_DIR nlopt.hpp)
find_library(NLopt_LIBRARY NAMES nlopt_cxx nlopt)
mark_as_advanced(NLopt_INCLUDE_DIR NLopt_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(NLopt REQUIRED_VARS NLopt_LIBRARY NLopt_INCLUDE_DIR)

if(NLopt_FOUND AND NOT TARGET NLopt::nlopt)
  add_library(NLopt::nlopt UNKNOWN IMPORTED)
  set_target_properties(NLopt::nlopt PROPERTIES
    IMPORTED_LOCATION "${NLopt_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${NLopt_INCLUDE_DIR}")
endif()
