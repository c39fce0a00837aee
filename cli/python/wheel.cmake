# cmake -DPACKAGE=... -DOUTPUT=... -DVERSION=... -DTAG=... -DLICENSE=... -P wheel.cmake
#
# Packs the Python package into OUTPUT/stillpoint-VERSION-TAG.whl, which pip installs. A wheel is a zip file
# of the package and of a folder that describes it. NLopt and fmt are the system's libraries.
set(info stillpoint-${VERSION}.dist-info)
set(staging "${OUTPUT}/staging")
file(REMOVE_RECURSE "${OUTPUT}")
file(GLOB modules "${PACKAGE}/*.so" "${PACKAGE}/*.py" "${PACKAGE}/*.pyi" "${PACKAGE}/py.typed")
file(COPY ${modules} DESTINATION "${staging}/stillpoint")
file(COPY "${LICENSE}" DESTINATION "${staging}/${info}")
file(WRITE "${staging}/${info}/WHEEL"
  "Wheel-Version: 1.0\nGenerator: CMake\nRoot-Is-Purelib: false\nTag: ${TAG}\n")
file(WRITE "${staging}/${info}/METADATA"
  "Metadata-Version: 2.1\nName: stillpoint\nVersion: ${VERSION}\nSummary: Sizes friction dampers\nLicense: MIT\nRequires-Python: >=3.9\nRequires-Dist: numpy\n")
file(GLOB_RECURSE all RELATIVE "${staging}" "${staging}/*")
list(TRANSFORM all APPEND ",,")
list(JOIN all "\n" record)
file(WRITE "${staging}/${info}/RECORD" "${record}\n${info}/RECORD,,\n")
set(wheel "${OUTPUT}/stillpoint-${VERSION}-${TAG}.whl")
execute_process(COMMAND "${CMAKE_COMMAND}" -E tar cf "${wheel}" --format=zip stillpoint ${info}
  WORKING_DIRECTORY "${staging}" COMMAND_ERROR_IS_FATAL ANY)
file(REMOVE_RECURSE "${staging}")
message(STATUS "${wheel}")
