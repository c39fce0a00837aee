# cpack runs this between installing the parts and packing them. It gives each tree what Debian
# requires of a package and a plain installation does not need: compressed pages and changelogs, its own places
# for completions of zsh and for modules of Python.

# The date of the packages is SOURCE_DATE_EPOCH if that is set.
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)

function(compress)
  # Without name and time: the same file gives the same bytes.
  execute_process(COMMAND gzip -9n ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# changelogs TREE PACKAGE: the project's and, for this one package, Debian's.
function(changelogs tree package)
  set(folder "${tree}/share/doc/${package}")
  file(COPY_FILE "${CPACK_STILLPOINT_CHANGELOG}" "${folder}/changelog")
  file(WRITE "${folder}/changelog.Debian"
"stillpoint (${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}) unstable; urgency=medium

  * Packed from the project's own tree.

 -- ${CPACK_PACKAGE_CONTACT}  ${date}
")
  file(CHMOD "${folder}/changelog" "${folder}/changelog.Debian"
    PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ)
  compress("${folder}/changelog" "${folder}/changelog.Debian")
endfunction()

set(program "${CPACK_TEMPORARY_DIRECTORY}/program${CPACK_PACKAGING_INSTALL_PREFIX}")
changelogs("${program}" stillpoint)
compress("${program}/share/man/man1/stillpoint.1")
if(EXISTS "${program}/share/zsh/site-functions")
  file(RENAME "${program}/share/zsh/site-functions" "${program}/share/zsh/vendor-completions")
endif()

set(development "${CPACK_TEMPORARY_DIRECTORY}/development${CPACK_PACKAGING_INSTALL_PREFIX}")
changelogs("${development}" libstillpoint-dev)

set(trees "${CPACK_TEMPORARY_DIRECTORY}/program" "${CPACK_TEMPORARY_DIRECTORY}/development")
set(python "${CPACK_TEMPORARY_DIRECTORY}/python${CPACK_PACKAGING_INSTALL_PREFIX}")
if(EXISTS "${python}")
  changelogs("${python}" python3-stillpoint)
  file(GLOB by_hand "${python}/lib/python3.*")
  if(by_hand)
    file(RENAME "${by_hand}" "${python}/lib/python3")
  endif()
  list(APPEND trees "${CPACK_TEMPORARY_DIRECTORY}/python")
endif()

# Folders are open to all, whatever the umask.
file(CHMOD_RECURSE ${trees}
  DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE
                        GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
