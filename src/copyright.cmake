# Reads ${ROOT}/assets/copyright: whose the files are, and the licences in full.

# fumon_licences(TEXT VARIABLE): the SPDX names of the licences whose texts it has.
function(fumon_licences text variable)
    string(REGEX MATCHALL "\n\nLicense: [A-Za-z0-9.-]+" names "${text}")
    list(TRANSFORM names REPLACE "^\n\nLicense: " "")
    set(${variable} ${names} PARENT_SCOPE)
endfunction()

# fumon_paragraph(TEXT START VARIABLE): the paragraph that begins so, its first line included.
function(fumon_paragraph text start variable)
    string(FIND "${text}\n\n" "\n\n${start}" begin)
    if(begin LESS 0)
        message(FATAL_ERROR "assets/copyright has no paragraph \"${start}\"")
    endif()
    math(EXPR begin "${begin} + 2")
    string(SUBSTRING "${text}\n\n" ${begin} -1 text)
    string(FIND "${text}" "\n\n" end)
    string(SUBSTRING "${text}" 0 ${end} text)
    set(${variable} "${text}" PARENT_SCOPE)
endfunction()

# fumon_licence_text(TEXT NAME VARIABLE): a licence as plain text.
function(fumon_licence_text text name variable)
    fumon_paragraph("${text}" "License: ${name}\n" paragraph)
    string(REPLACE "\n " "\n" text "${paragraph}\n")
    string(REPLACE "\n.\n" "\n\n" text "${text}")
    string(FIND "${text}" "\n" first)
    math(EXPR first "${first} + 1")
    string(SUBSTRING "${text}" ${first} -1 text)
    set(${variable} "${text}" PARENT_SCOPE)
endfunction()
