# Run by CPack before it packs, for packages of any kind.
if(CPACK_TOPLEVEL_TAG MATCHES "Source")
    include(${CMAKE_CURRENT_LIST_DIR}/packages_source.cmake)
    return()
endif()

# A folder for each component's files lies in ${CPACK_TEMPORARY_DIRECTORY}.
find_program(gzip gzip REQUIRED)
file(GLOB manuals ${CPACK_TEMPORARY_DIRECTORY}/*/usr/share/man/man*/*.[1-9])
foreach(manual IN LISTS manuals)
    execute_process(COMMAND ${gzip} -9n ${manual} COMMAND_ERROR_IS_FATAL ANY)
endforeach()

# Whose the files are, by their paths in the sources, which lie in more than one place; the other packages have none of others.
include(${CMAKE_CURRENT_LIST_DIR}/copyright.cmake)
file(READ ${CMAKE_CURRENT_LIST_DIR}/../assets/copyright of_data)
string(REGEX REPLACE "\nComment: Whose[^\n]*(\n [^\n]*)*" "" of_data "${of_data}")
fumon_paragraph("${of_data}" "Files: *" all_files)
fumon_paragraph("${of_data}" "License: MIT\n" licence)
string(REGEX MATCH "^[^\n]*\n[^\n]*\n" head "${of_data}")
set(of_others "${head}\n${all_files}\n\n${licence}\n")
string(REPLACE " assets/" " */assets/" of_data "${of_data}")
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)

foreach(component IN LISTS CPACK_COMPONENTS_ALL)
    string(TOUPPER ${component} name)
    set(package ${CPACK_DEBIAN_${name}_PACKAGE_NAME})
    set(folder ${CPACK_TEMPORARY_DIRECTORY}/${component}/usr/share/doc/${package})
    set(copyright "${of_others}")
    if(component STREQUAL "data")
        set(copyright "${of_data}")
    endif()
    string(REPLACE "License: MIT\n" "License: Expat\n" copyright "${copyright}")  # as Debian calls it
    file(WRITE ${folder}/copyright "${copyright}")
    file(WRITE ${folder}/changelog.Debian "${package} (${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}) unstable; urgency=medium

  * Packaged by CPack; what has changed is told in
    /usr/share/doc/fumon/assets/guide/CHANGELOG.md.

 -- ${CPACK_PACKAGE_CONTACT}  ${date}
")
    execute_process(COMMAND ${gzip} -9n ${folder}/changelog.Debian COMMAND_ERROR_IS_FATAL ANY)
    file(GLOB texts ${folder}/copyright ${folder}/changelog.Debian.gz)
    file(CHMOD ${texts} PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ)
endforeach()
