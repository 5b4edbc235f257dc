# The package fumon, complete in ${CMAKE_BINARY_DIR}/python: PYTHONPATH may lead there.
set(package ${CMAKE_BINARY_DIR}/python/fumon)
python_add_library(fumon_python_module MODULE WITH_SOABI python_module.cpp)
target_link_libraries(fumon_python_module PRIVATE fumon_python pybind11::module)
set_target_properties(fumon_python_module PROPERTIES OUTPUT_NAME _core LIBRARY_OUTPUT_DIRECTORY ${package}
                      CXX_VISIBILITY_PRESET hidden)
target_compile_options(fumon_python PRIVATE $<$<CONFIG:Release>:-O1>)

file(GLOB package_files CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/python/fumon/*)
list(FILTER package_files EXCLUDE REGEX "__pycache__")
file(MAKE_DIRECTORY ${package})
foreach(file IN LISTS package_files)
    get_filename_component(name ${file} NAME)
    file(CREATE_LINK ${file} ${package}/${name} SYMBOLIC)
endforeach()

# Where this Python looks for packages below a prefix.
set(FUMON_PYTHON_FOLDER lib/python${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}/dist-packages CACHE STRING
    "The folder of the Python package, below the prefix")
install(TARGETS fumon_python_module LIBRARY DESTINATION ${FUMON_PYTHON_FOLDER}/fumon COMPONENT python)
install(FILES ${package_files} DESTINATION ${FUMON_PYTHON_FOLDER}/fumon COMPONENT python)

# What pip and pytest know a package by, the plugin of pytest among it; pip writes its own from the same pyproject.toml.
set(project_file ${CMAKE_CURRENT_SOURCE_DIR}/python/pyproject.toml)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${project_file})
file(READ ${project_file} project)
string(REGEX MATCH "\ndescription = \"([^\"]+)\"" found "${project}")
set(summary ${CMAKE_MATCH_1})
string(REGEX MATCH "\nrequires-python = \"([^\"]+)\"" found "${project}")
set(python_versions ${CMAKE_MATCH_1})
string(REGEX MATCH "\nfumon = \"([a-z_.]+)\"" found "${project}")
set(plugin ${CMAKE_MATCH_1})
string(REGEX MATCH "\nauthors = \\[{name = \"([^\"]+)\"" found "${project}")
set(author ${CMAKE_MATCH_1})
string(REGEX MATCH "\nclassifiers = \\[\n([^]]+)\n\\]" found "${project}")
string(REGEX REPLACE " *\"([^\"]+)\",?" "Classifier: \\1" classifiers "${CMAKE_MATCH_1}")
if(NOT summary OR NOT python_versions OR NOT plugin OR NOT author OR NOT classifiers)
    message(FATAL_ERROR "${project_file} has no description, requires-python, authors, classifiers or plugin of pytest")
endif()
set(address "")
if(FUMON_HOMEPAGE)
    set(address "\nProject-URL: Homepage, ${FUMON_HOMEPAGE}")
endif()
set(about ${CMAKE_BINARY_DIR}/share/fumon-${PROJECT_VERSION}.dist-info)
file(CONFIGURE OUTPUT ${about}/METADATA CONTENT "Metadata-Version: 2.1
Name: fumon
Version: @PROJECT_VERSION@
Summary: @summary@
Author: @author@
License: MIT
License-File: LICENSE
License-File: copyright@address@
@classifiers@
Requires-Python: @python_versions@
Requires-Dist: numpy
" @ONLY)
configure_file(${CMAKE_SOURCE_DIR}/LICENSE ${about}/LICENSE COPYONLY)
configure_file(${CMAKE_SOURCE_DIR}/assets/copyright ${about}/copyright COPYONLY)
file(CONFIGURE OUTPUT ${about}/entry_points.txt CONTENT "[pytest11]\nfumon = @plugin@\n" @ONLY)
install(DIRECTORY ${about} DESTINATION ${FUMON_PYTHON_FOLDER} COMPONENT python)
