# Executables of the tests of some rooms, and their names in CTest.

# Of a list of files those whose tests speak of threads.
function(keep_files_of_threads list)
    set(kept "")
    foreach(source IN LISTS ${list})
        file(STRINGS ${source} lines REGEX "^TEST.*(Threads|WorkerPool)")
        if(lines)
            list(APPEND kept ${source})
        endif()
    endforeach()
    set(${list} ${kept} PARENT_SCOPE)
endfunction()

# add_suites(NAME LABEL SOURCES): a CTest test NAME.Suite for each suite of GoogleTest in the sources, since a process a test
# would spend more time on its start than on most tests, and NAME.others for what was not seen here, which is nothing.
function(add_suites name label)
    if(FUMON_SANITIZE STREQUAL "thread" AND NOT name STREQUAL "runs")
        add_test(NAME ${name}.threads COMMAND fumon_${name}_tests --gtest_filter=*Threads*:WorkerPool.*)
        set_tests_properties(${name}.threads PROPERTIES TIMEOUT 600 LABELS ${label})
        return()
    endif()
    set(suites "")
    foreach(source IN LISTS ARGN)
        file(STRINGS ${source} lines REGEX "^TEST(_F|_P)?\\(")
        list(TRANSFORM lines REPLACE "^TEST[_FP]*\\(([A-Za-z0-9]+),.*" "\\1")
        list(APPEND suites ${lines})
    endforeach()
    list(REMOVE_DUPLICATES suites)
    set(left_out "")
    if(FUMON_SANITIZE)
        set(beside addresses)
        if(FUMON_SANITIZE STREQUAL "thread")
            set(beside threads)
        endif()
        file(STRINGS ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/sanitizers/beside_${beside}.txt left_out REGEX "^[^#]")
        list(JOIN left_out ":" left_out)
        set(left_out "-${left_out}")
    endif()
    set(seen "")
    foreach(suite IN LISTS suites)
        set(filter "${suite}.*:*/${suite}.*")
        string(APPEND seen "${filter}:")
        add_test(NAME ${name}.${suite} COMMAND fumon_${name}_tests --gtest_filter=${filter}${left_out})
        list(APPEND tests ${name}.${suite})
    endforeach()
    add_test(NAME ${name}.others COMMAND fumon_${name}_tests --gtest_filter=-${seen})
    set_tests_properties(${tests} ${name}.others PROPERTIES TIMEOUT 600 LABELS ${label})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${ARGN})
endfunction()

# fumon_tests(NAME LIBRARY FOLDERS folder... [LABEL label]): one executable of every .cpp in some rooms' folders; its tests
# are called NAME.Suite and labelled NAME, unless LABEL says otherwise. ThreadSanitizer has of runs the files of
# sanitizers/of_threads.txt, of the others tests of threads.
function(fumon_tests name library)
    cmake_parse_arguments(tests "" "LABEL" "FOLDERS" ${ARGN})
    set(sources "")
    foreach(folder IN LISTS tests_FOLDERS)
        file(GLOB found CONFIGURE_DEPENDS ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/${folder}/*.cpp)
        list(APPEND sources ${found})
    endforeach()
    if(FUMON_SANITIZE STREQUAL "thread" AND NOT name STREQUAL "runs")
        keep_files_of_threads(sources)
    elseif(FUMON_SANITIZE STREQUAL "thread")
        file(STRINGS ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/sanitizers/of_threads.txt files REGEX "^[^#]")
        list(TRANSFORM files REPLACE "(.+)" "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/\\1.cpp")
        set(sources ${files})
    endif()
    set(target fumon_${name}_tests)
    add_executable(${target} ${sources} ${leak_check})
    target_link_libraries(${target} PRIVATE ${library} GTest::gtest GTest::gtest_main)
    target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_FUNCTION_LIST_DIR})
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-Og>)  # half the time to compile
    if(FUMON_SANITIZE AND NOT name STREQUAL "models")  # whose plain loops are held against those of fumon
        target_compile_options(${target} PRIVATE -O0)
    endif()
    target_compile_definitions(${target} PRIVATE
        FUMON_TEST_FOLDER="${CMAKE_CURRENT_FUNCTION_LIST_DIR}"
        FUMON_SOURCES_FOLDER="${CMAKE_SOURCE_DIR}/src"
        FUMON_SCENES_FOLDER="${CMAKE_SOURCE_DIR}/scenes"
        FUMON_TERRAIN_FOLDER="${CMAKE_SOURCE_DIR}/assets/terrain"
        FUMON_ROOMS="${CMAKE_BINARY_DIR}/rooms.txt")
    set(label ${name} ${tests_LABEL})
    list(GET label -1 label)
    add_suites(${name} ${label} ${sources})
endfunction()
