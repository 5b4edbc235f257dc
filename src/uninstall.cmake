# Takes away what `cmake --install` wrote, by the list that it leaves in the build folder, under $DESTDIR where that is set:
#   cmake -D BUILD=build-folder -P uninstall.cmake
# Folders of fumon's own go where they are empty then; those of the system stay.

cmake_minimum_required(VERSION 3.25)

# Each line by itself: as a list of CMake, paths with semicolons or brackets would be torn.
function(remove_listed manifest)
    file(READ "${manifest}" left)
    string(APPEND left "\n")
    while(NOT left STREQUAL "")
        string(FIND "${left}" "\n" end)
        string(SUBSTRING "${left}" 0 ${end} file)
        math(EXPR end "${end} + 1")
        string(SUBSTRING "${left}" ${end} -1 left)
        if(file STREQUAL "")
            continue()
        endif()
        set(file "$ENV{DESTDIR}${file}")
        if(EXISTS "${file}" OR IS_SYMLINK "${file}")
            file(REMOVE "${file}")
            if(EXISTS "${file}" OR IS_SYMLINK "${file}")
                message(FATAL_ERROR "${file} cannot be removed")
            endif()
            math(EXPR removed "${removed} + 1")
        endif()
        cmake_path(GET file PARENT_PATH folder)
        if(file MATCHES "/fumon/[^/]+[.]py$")
            file(REMOVE_RECURSE "${folder}/__pycache__")  # which Python wrote of it
        endif()
        while("${folder}" MATCHES "/(share|include|lib[^/]*)/(.*/)?fumon")
            execute_process(COMMAND rmdir -- "${folder}" OUTPUT_QUIET ERROR_QUIET)  # which leaves what holds anything
            cmake_path(GET folder PARENT_PATH folder)
        endwhile()
    endwhile()
    set(removed ${removed} PARENT_SCOPE)
endfunction()

# Lists of components are not asked: cpack leaves such, too, of files that it packed and did not install.
set(removed 0)
set(manifest "${BUILD}/install_manifest.txt")
if(NOT EXISTS "${manifest}")
    message(FATAL_ERROR "${BUILD} has no install_manifest.txt: nothing was installed from there as a whole")
endif()
remove_listed("${manifest}")
message("${removed} files removed")
