# Writes the list of the parts of a build, an SPDX document (spdx.dev, version 2.3) in JSON: fumon, the files in it that are others',
# and the libraries that it is linked with, each with the package that it is from where the system's packages tell. The same build
# writes the same bytes.
#   cmake -D ROOT=sources -D VERSION=0.3.0 -D DATE=YYYY-MM-DD -D PROGRAM=fumon -D HEADERS=name=version;… -D TO=file -P sbom.cmake
# LIBRARIES, paths, takes the place of what PROGRAM is linked with: of those that travel in an archive.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/copyright.cmake)

function(quoted text variable)
    string(REPLACE "\\" "\\\\" text "${text}")
    string(REPLACE "\"" "\\\"" text "${text}")
    string(REPLACE "\n" "\\n" text "${text}")
    set(${variable} "\"${text}\"" PARENT_SCOPE)
endfunction()

set(packages "")
set(relations "")

# part(NAME RELATION [VERSION v] [LICENCE l] [COPYRIGHT c] [PURPOSE p] [SHA256 s] [URL purl])
function(part name relation)
    cmake_parse_arguments(the "" "VERSION;LICENCE;COPYRIGHT;PURPOSE;SHA256;URL" "" ${ARGN})
    string(REGEX REPLACE "[^A-Za-z0-9.]" "-" id "SPDXRef-${name}")
    quoted("${name}" name)
    set(fields "\"SPDXID\": \"${id}\", \"name\": ${name}, \"downloadLocation\": \"NOASSERTION\", \"filesAnalyzed\": false")
    foreach(field IN ITEMS VERSION:versionInfo PURPOSE:primaryPackagePurpose LICENCE:licenseDeclared COPYRIGHT:copyrightText)
        string(REPLACE ":" ";" field ${field})
        list(GET field 0 key)
        list(GET field 1 field)
        if(the_${key})
            quoted("${the_${key}}" value)
            string(APPEND fields ", \"${field}\": ${value}")
        endif()
    endforeach()
    if(the_SHA256)
        string(APPEND fields ", \"checksums\": [{\"algorithm\": \"SHA256\", \"checksumValue\": \"${the_SHA256}\"}]")
    endif()
    if(the_URL)
        string(APPEND fields ", \"externalRefs\": [{\"referenceCategory\": \"PACKAGE-MANAGER\", \"referenceType\": \"purl\", \"referenceLocator\": \"${the_URL}\"}]")
    endif()
    set(from SPDXRef-fumon)
    if(relation STREQUAL "DESCRIBES")
        set(from SPDXRef-DOCUMENT)
    endif()
    set(packages "${packages},\n    {${fields}}" PARENT_SCOPE)
    set(relations "${relations},\n    {\"spdxElementId\": \"${from}\", \"relationshipType\": \"${relation}\", \"relatedSpdxElement\": \"${id}\"}" PARENT_SCOPE)
endfunction()

part(fumon DESCRIBES VERSION ${VERSION} LICENCE MIT COPYRIGHT "2026 the fumon authors" PURPOSE APPLICATION)

# Files of others.
file(READ ${ROOT}/assets/copyright copyright)
string(REPLACE ";" "," stanzas "${copyright}")
string(REPLACE "[" "(" stanzas "${stanzas}")
string(REPLACE "]" ")" stanzas "${stanzas}")
string(REPLACE "\n\n" ";" stanzas "${stanzas}")
foreach(stanza IN LISTS stanzas)
    if(NOT stanza MATCHES "^Files: (assets/[^:]+)\nCopyright: ([^\n]+)\nLicense: ([^\n]+)")
        continue()
    endif()
    set(holder "${CMAKE_MATCH_2}")
    set(licence "${CMAKE_MATCH_3}")
    string(REGEX MATCHALL "[^ \n]+" files "${CMAKE_MATCH_1}")
    if(holder MATCHES "the fumon authors")
        continue()
    endif()
    foreach(file IN LISTS files)
        file(SHA256 ${ROOT}/${file} hash)
        part(${file} CONTAINS LICENCE ${licence} COPYRIGHT "${holder}" PURPOSE FILE SHA256 ${hash})
    endforeach()
endforeach()

# What was compiled in.
foreach(header IN LISTS HEADERS)
    string(REPLACE "=" ";" header "${header}")
    list(GET header 0 name)
    list(GET header 1 version)
    part(${name} STATIC_LINK VERSION ${version} LICENCE NOASSERTION PURPOSE LIBRARY)
endforeach()

# The libraries and their packages.
if(NOT LIBRARIES)
    execute_process(COMMAND readelf -d ${PROGRAM} OUTPUT_VARIABLE needed ERROR_QUIET)
    string(REGEX MATCHALL "NEEDED[^\n]*" needed "${needed}")
    list(TRANSFORM needed REPLACE ".*: .(.+).$" "\\1")
    file(GET_RUNTIME_DEPENDENCIES RESOLVED_DEPENDENCIES_VAR resolved UNRESOLVED_DEPENDENCIES_VAR unresolved EXECUTABLES ${PROGRAM})
    foreach(library IN LISTS resolved)
        cmake_path(GET library FILENAME name)
        if(name IN_LIST needed)
            list(APPEND LIBRARIES ${library})
        endif()
    endforeach()
endif()
list(SORT LIBRARIES)
find_program(dpkg_query dpkg-query)
find_program(dpkg dpkg)
set(system debian)
set(architecture "")
if(dpkg)
    execute_process(COMMAND ${dpkg} --print-architecture OUTPUT_VARIABLE architecture OUTPUT_STRIP_TRAILING_WHITESPACE)
    file(STRINGS /etc/os-release system REGEX "^ID=")
    string(REGEX REPLACE "^ID=\"?([a-z]+).*" "\\1" system "${system}")
endif()
foreach(library IN LISTS LIBRARIES)
    cmake_path(GET library FILENAME name)
    set(about "")
    if(dpkg_query)
        file(REAL_PATH ${library} real)
        string(REGEX REPLACE "^/usr/lib/" "/lib/" before_merge ${real})
        foreach(path IN ITEMS ${real} ${before_merge})
            execute_process(COMMAND ${dpkg_query} -S ${path} OUTPUT_VARIABLE owner ERROR_QUIET RESULT_VARIABLE unknown)
            if(unknown EQUAL 0)
                string(REGEX REPLACE ":.*" "" owner "${owner}")
                execute_process(COMMAND ${dpkg_query} -W -f "\${Version}\n" ${owner}:${architecture} OUTPUT_VARIABLE version ERROR_QUIET
                                OUTPUT_STRIP_TRAILING_WHITESPACE)
                string(REPLACE "+" "%2B" in_url "${version}")
                string(REPLACE "~" "%7E" in_url "${in_url}")
                string(REPLACE ":" "%3A" in_url "${in_url}")
                set(about VERSION "${version}" URL "pkg:deb/${system}/${owner}@${in_url}?arch=${architecture}")
                break()
            endif()
        endforeach()
    endif()
    part(${name} DYNAMIC_LINK LICENCE NOASSERTION PURPOSE LIBRARY ${about})
endforeach()

# Licences that SPDX has no name of.
set(texts "")
fumon_licences("${copyright}" licences)
foreach(licence IN LISTS licences)
    if(licence MATCHES "^LicenseRef-")
        fumon_licence_text("${copyright}" ${licence} text)
        quoted("${text}" text)
        string(APPEND texts ",\n    {\"licenseId\": \"${licence}\", \"extractedText\": ${text}}")
    endif()
endforeach()

string(SUBSTRING "${packages}" 1 -1 packages)
string(SUBSTRING "${relations}" 1 -1 relations)
string(SUBSTRING "${texts}" 1 -1 texts)
string(UUID number NAMESPACE 6ba7b811-9dad-11d1-80b4-00c04fd430c8 NAME "${packages}" TYPE SHA1)
file(CONFIGURE OUTPUT ${TO} @ONLY CONTENT "{
  \"spdxVersion\": \"SPDX-2.3\",
  \"dataLicense\": \"CC0-1.0\",
  \"SPDXID\": \"SPDXRef-DOCUMENT\",
  \"name\": \"fumon-@VERSION@\",
  \"documentNamespace\": \"https://spdx.org/spdxdocs/fumon-@VERSION@-@number@\",
  \"creationInfo\": {\"created\": \"@DATE@T00:00:00Z\", \"creators\": [\"Tool: fumon-build-@VERSION@\"]},
  \"packages\": [@packages@
  ],
  \"relationships\": [@relations@
  ],
  \"hasExtractedLicensingInfos\": [@texts@
  ]
}
")
