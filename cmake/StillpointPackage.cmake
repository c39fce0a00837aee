# `cpack` in the build directory makes a Debian package of each installed part: stillpoint, the program,
# libstillpoint-dev, the libraries, and python3-stillpoint, where the module is built. ./dev package does it with the paths that
# Debian has for packages; any other Release build gives packages that work as well.

set(CPACK_GENERATOR DEB)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_PACKAGE_VENDOR "The stillpoint authors")
set(CPACK_PACKAGE_CONTACT "The stillpoint authors <stillpoint@users.noreply.invalid>"
    CACHE STRING "Maintainer of the Debian packages, NAME <ADDRESS>")
set(CPACK_STRIP_FILES ON)

set(CPACK_COMPONENTS_ALL program development)
if(STILLPOINT_BUILD_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_STILLPOINT_CHANGELOG "${PROJECT_SOURCE_DIR}/CHANGELOG.md")
set(CPACK_PRE_BUILD_SCRIPTS "${PROJECT_SOURCE_DIR}/cmake/finish_debian_tree.cmake")

# Each package has its own first line, so there is no common one.
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME stillpoint)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION
"design of friction dampers for vibration and seismic isolation
stillpoint sizes dampers with constant friction and point friction, a loss of
energy at every passage through the rest position: it finds those for which a
mass on a spring comes to rest at its rest position on the first return. It
says how far off the built damper may be, checks each answer by two other
methods and follows free and forced motion exactly from event to event.")

# The libraries are static: their users link what they use. The names inside fmt carry
# its major version, so the libraries need the one they were built with.
find_package(fmt REQUIRED CONFIG)  # for its version
math(EXPR next_fmt "${fmt_VERSION_MAJOR} + 1")
string(JOIN ", " CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
  "libeigen3-dev (>= 3.4)"
  "libfmt-dev (>= ${fmt_VERSION_MAJOR})" "libfmt-dev (<< ${next_fmt})"
  "libhwy-dev (>= 1.0)"
  libnlopt-cxx-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libstillpoint-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS stillpoint)
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION
"design of friction dampers, the C++ libraries
The exact motion of an oscillator with constant and point friction, free and
forced, one at a time and in batches; the design of its damper. These are the
headers and static libraries, for CMake (find_package) and pkg-config; they
need C++20.")

# The module is built for one version of Python.
if(STILLPOINT_BUILD_PYTHON)
  math(EXPR next_python "${Python_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-stillpoint)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
    "python3 (>= 3.${Python_VERSION_MINOR}~), python3 (<< 3.${next_python}), python3-numpy")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "stillpoint, python3-matplotlib")
  set(CPACK_DEBIAN_PYTHON_DESCRIPTION
"design of friction dampers, the Python module
Designs, regions, motions and sweeps of friction dampers from keyword arguments,
with the program's numbers, reports and figures, and arrays of NumPy for many
dampers at once: import stillpoint.")
endif()

include(CPack)
