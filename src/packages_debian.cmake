# Run by CPack before it packs: a folder for each component's files lies in ${CPACK_TEMPORARY_DIRECTORY}.
find_program(gzip gzip REQUIRED)
file(GLOB manuals ${CPACK_TEMPORARY_DIRECTORY}/*/usr/share/man/man*/*.[1-9])
foreach(manual IN LISTS manuals)
    execute_process(COMMAND ${gzip} -9n ${manual} COMMAND_ERROR_IS_FATAL ANY)
endforeach()

# The licence as a field of a control file, whose lines are indented and whose empty lines are dots.
file(READ ${CMAKE_CURRENT_LIST_DIR}/../LICENSE license)
string(REPLACE "\n\n" "\n.\n" license "${license}")
string(REGEX REPLACE "\n([^\n])" "\n \\1" license "${license}")
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)

foreach(component IN LISTS CPACK_COMPONENTS_ALL)
    string(TOUPPER ${component} name)
    set(package ${CPACK_DEBIAN_${name}_PACKAGE_NAME})
    set(folder ${CPACK_TEMPORARY_DIRECTORY}/${component}/usr/share/doc/${package})
    set(letters "")
    if(component STREQUAL "data")  # whose letters are another's
        file(READ ${CMAKE_CURRENT_LIST_DIR}/../assets/fonts/README.md letters)
        string(REGEX MATCH "\n> Permission is hereby granted.*" letters "${letters}")
        string(REGEX REPLACE "\n>( ?)([^\n]*)" "\n \\2" letters "${letters}")
        string(REGEX REPLACE "\n +\n" "\n .\n" letters "${letters}")
        string(STRIP "${letters}" letters)
        set(letters "
Files: usr/share/fumon/assets/fonts/*
Copyright: 2003 Bitstream, Inc.
License: bitstream-vera
 ${letters}
")
    endif()
    file(WRITE ${folder}/copyright "Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: fumon

Files: *
Copyright: 2026 the fumon authors
License: Expat
 ${license}${letters}")
    file(WRITE ${folder}/changelog.Debian "${package} (${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}) unstable; urgency=medium

  * Packaged by CPack; what has changed is told in
    /usr/share/doc/fumon/assets/guide/CHANGELOG.md.

 -- ${CPACK_PACKAGE_CONTACT}  ${date}
")
    execute_process(COMMAND ${gzip} -9n ${folder}/changelog.Debian COMMAND_ERROR_IS_FATAL ANY)
    file(GLOB texts ${folder}/copyright ${folder}/changelog.Debian.gz)
    file(CHMOD ${texts} PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ)
endforeach()
