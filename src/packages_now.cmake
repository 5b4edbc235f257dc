# Read by cpack each time: who packs, which a build folder does not know. As Debian's own tools ask for it, DEBFULLNAME and
# DEBEMAIL; else user and machine. `cpack -D CPACK_PACKAGE_CONTACT="Name <address>"` comes before both.
if(NOT CPACK_PACKAGE_CONTACT)
    set(packager "$ENV{DEBFULLNAME}")
    set(address "$ENV{DEBEMAIL}")
    if(NOT packager)
        set(packager "who built this package of fumon")
    endif()
    if(NOT address)
        cmake_host_system_information(RESULT machine QUERY FQDN)
        execute_process(COMMAND id -un OUTPUT_VARIABLE user OUTPUT_STRIP_TRAILING_WHITESPACE)
        set(address "${user}@${machine}")
    endif()
    set(CPACK_PACKAGE_CONTACT "${packager} <${address}>")
endif()
if(CPACK_TOPLEVEL_TAG MATCHES "Source")
    set(CPACK_PACKAGING_INSTALL_PREFIX "")  # which is that of the other packages
endif()
