# libfumonbmi, and what a program needs to be built with it: headers, a file for pkg-config, and a package for find_package.
include(CMakePackageConfigHelpers)

add_library(fumon_bmi_library SHARED bmi_library.cpp)
target_link_libraries(fumon_bmi_library PRIVATE fumon_bmi)
target_include_directories(fumon_bmi_library INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
                           $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/fumon>)
set_target_properties(fumon_bmi_library PROPERTIES OUTPUT_NAME fumonbmi EXPORT_NAME bmi LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}
                      VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR})
install(TARGETS fumon_bmi_library EXPORT fumonbmi LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT bmi)
install(FILES bmi/bmi.h bmi/bmi_library.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/fumon COMPONENT bmi)
# As the specification's own header is called.
install(FILES bmi/bmi.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/fumon RENAME bmi.hxx COMPONENT bmi)

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/fumonbmi)
install(EXPORT fumonbmi FILE fumonbmiConfig.cmake NAMESPACE fumon:: DESTINATION ${package} COMPONENT bmi)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/share/fumonbmiConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/share/fumonbmiConfigVersion.cmake DESTINATION ${package} COMPONENT bmi)

# Its prefix is found from where it lies, so that an installed folder may be moved.
file(RELATIVE_PATH up /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
string(REGEX REPLACE "/$" "" up "${up}")
file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/share/fumonbmi.pc CONTENT "prefix=\${pcfiledir}/@up@
libdir=\${prefix}/@CMAKE_INSTALL_LIBDIR@
includedir=\${prefix}/@CMAKE_INSTALL_INCLUDEDIR@

Name: fumonbmi
Description: Models of sand and water landforms as components of the Basic Model Interface
Version: @PROJECT_VERSION@
Libs: -L\${libdir} -lfumonbmi
Cflags: -I\${includedir} -I\${includedir}/fumon
" @ONLY)
install(FILES ${CMAKE_BINARY_DIR}/share/fumonbmi.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT bmi)
