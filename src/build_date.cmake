# The day of the sources that a build is made of, which does not depend on when or where it is made. The tests run it:
#   cmake -D ROOT=folder-of-the-sources -P build_date.cmake

# fumon_build_date(ROOT VARIABLE): YYYY-MM-DD, in UTC: of SOURCE_DATE_EPOCH (reproducible-builds.org), which packagers set; else
# of the first heading of the change log, where it is that of a release; else of the last commit, where ROOT is a checkout; else
# of the last release that the change log names.
function(fumon_build_date root variable)
    if("$ENV{SOURCE_DATE_EPOCH}" MATCHES "^[0-9]+$")
        string(TIMESTAMP day "%Y-%m-%d" UTC)
        set(${variable} ${day} PARENT_SCOPE)
        return()
    endif()
    file(STRINGS ${root}/assets/guide/CHANGELOG.md headings REGEX "^## ")
    list(GET headings 0 first)
    if(NOT first MATCHES "\\([0-9-]+\\)$" AND EXISTS ${root}/.git)
        execute_process(COMMAND ${CMAKE_COMMAND} -E env TZ=UTC0 git -C ${root} log -1 --format=%cd
                        --date=format-local:%Y-%m-%d RESULT_VARIABLE failed OUTPUT_VARIABLE day OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
        if(failed STREQUAL "0" AND day MATCHES "^[0-9-]+$")
            set(${variable} ${day} PARENT_SCOPE)
            return()
        endif()
    endif()
    string(REGEX MATCH "[0-9][0-9][0-9][0-9]-[0-9][0-9]-[0-9][0-9]" day "${headings}")
    set(${variable} "${day}" PARENT_SCOPE)
endfunction()

if(CMAKE_SCRIPT_MODE_FILE)
    fumon_build_date(${ROOT} day)
    message("${day}")
endif()
