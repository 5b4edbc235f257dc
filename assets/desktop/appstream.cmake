# What software centres read: ${FUMON_METAINFO}, from fumon.metainfo.xml.in beside this file.

# Its name begins with a domain. fumon has none; example.org is kept for such cases, and nobody can have it (RFC 2606).
set(FUMON_APPSTREAM_ID org.example.fumon CACHE STRING
    "fumon's AppStream id: under a domain, or a name at a code host, of whoever publishes it")

# A release is a version with a date.
set(releases "")
set(citation ${CMAKE_SOURCE_DIR}/assets/guide/CITATION.cff)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${citation})
file(STRINGS ${citation} released REGEX "^date-released: ")
if(released MATCHES "([0-9]+-[0-9]+-[0-9]+)")
    set(releases "
  <releases>
    <release version=\"${PROJECT_VERSION}\" date=\"${CMAKE_MATCH_1}\"/>
  </releases>")
endif()
set(homepage "")
if(FUMON_HOMEPAGE)
    set(homepage "  <url type=\"homepage\">${FUMON_HOMEPAGE}</url>\n")
endif()
set(FUMON_METAINFO ${CMAKE_BINARY_DIR}/share/${FUMON_APPSTREAM_ID}.metainfo.xml)
configure_file(${CMAKE_CURRENT_LIST_DIR}/fumon.metainfo.xml.in ${FUMON_METAINFO} @ONLY)
