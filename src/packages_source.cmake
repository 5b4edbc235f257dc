# Run by CPack before it packs the sources, which lie in ${CPACK_TEMPORARY_DIRECTORY}: the licences, where the REUSE specification
# looks for them (https://reuse.software). `reuse lint` then finds nothing in the package.
include(${CMAKE_CURRENT_LIST_DIR}/copyright.cmake)
set(root "${CPACK_TEMPORARY_DIRECTORY}")
file(READ "${root}/assets/copyright" copyright)
fumon_licences("${copyright}" names)
foreach(name IN LISTS names)
    fumon_licence_text("${copyright}" ${name} text)
    file(WRITE "${root}/LICENSES/${name}.txt" "${text}")
endforeach()
file(WRITE "${root}/.reuse/dep5" "${copyright}")
