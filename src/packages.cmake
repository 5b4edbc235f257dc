# Debian packages, made by `cpack -G DEB` in a build folder: fumon (program, manual pages, completion), fumon-data
# (shaders, palettes, scenes, the guide), fumon-pictures (those of the scenes' page), fumon-bmi (libfumonbmi with what programs
# are built by), python3-fumon. Configure with --preset package, which sets the prefix /usr. `cpack --config
# CPackSourceConfig.cmake` makes the package of the sources.

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME fumon)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # which would stand above each package's own
set(CPACK_PACKAGE_CONTACT "" CACHE STRING "Who maintains the packages: name and address; empty: who runs cpack")
set(CPACK_PROJECT_CONFIG_FILE ${CMAKE_CURRENT_LIST_DIR}/packages_now.cmake)
set(CPACK_PACKAGE_HOMEPAGE_URL ${FUMON_HOMEPAGE})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ
    WORLD_EXECUTE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_COMPONENTS_ALL program data pictures)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(revision 0fumon1)  # below 1, Debian's own
set(CPACK_DEBIAN_PACKAGE_RELEASE ${revision})
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)

# OSMesa and EGL are loaded by name, which no linker sees: either is enough, EGL with drivers.
set(drawing "libosmesa6 | libegl1, libosmesa6 | libgl1-mesa-dri, fonts-dejavu-core | fontconfig")
# So is FFmpeg.
set(by_name "${drawing}, ${FUMON_LIBAV_PACKAGES}")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME fumon)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "fumon-data (= ${PROJECT_VERSION}-${revision}), ${by_name}")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "fonts-ipaexfont-gothic")

# GDAL is loaded by its name too: this release's is what apt takes, others do as well.
set(gdal libgdal32 libgdal34t64 libgdal36)
execute_process(COMMAND dpkg-query -W -f "\${Package};" "libgdal[0-9]*" OUTPUT_VARIABLE installed ERROR_QUIET)
list(PREPEND gdal ${installed})
list(REMOVE_DUPLICATES gdal)
list(JOIN gdal " | " gdal)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "${gdal}")
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "sand and water landforms, simulated and rendered
Ripples, dunes, barchans, sandpiles, gullies and rain on real terrain,
computed reproducibly to the bit and drawn as pictures, movies and paper
figures without a display.")

set(CPACK_DEBIAN_DATA_PACKAGE_NAME fumon-data)
set(CPACK_DEBIAN_DATA_PACKAGE_SECTION science)
set(CPACK_DEBIAN_DATA_PACKAGE_ARCHITECTURE all)
set(CPACK_COMPONENT_DATA_DESCRIPTION "shaders, palettes, scenes and guide of fumon
Sand and water landforms, simulated and rendered without a display: this
package holds what the program and the Python module read, and the guide.")

set(CPACK_DEBIAN_DATA_PACKAGE_SUGGESTS fumon-pictures)

set(CPACK_DEBIAN_PICTURES_PACKAGE_NAME fumon-pictures)
set(CPACK_DEBIAN_PICTURES_PACKAGE_SECTION doc)
set(CPACK_DEBIAN_PICTURES_PACKAGE_ARCHITECTURE all)
set(CPACK_COMPONENT_PICTURES_DESCRIPTION "pictures of the scenes of fumon
Sand and water landforms, simulated and rendered without a display: the
pictures of the page on the scenes that ship, each with its scene, so that
fumon makes it again, and of `fumon gallery --shipped`.")

if(FUMON_BMI_LIBRARY)
    list(APPEND CPACK_COMPONENTS_ALL bmi)
    set(CPACK_DEBIAN_BMI_PACKAGE_NAME fumon-bmi)
    set(CPACK_DEBIAN_BMI_PACKAGE_SECTION libdevel)
    set(CPACK_DEBIAN_BMI_PACKAGE_SHLIBDEPS ON)
    set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)  # for packages of programs that are built with it
    file(WRITE ${CMAKE_BINARY_DIR}/share/triggers "activate-noawait ldconfig\n")
    set(CPACK_DEBIAN_BMI_PACKAGE_CONTROL_EXTRA ${CMAKE_BINARY_DIR}/share/triggers)
    set(CPACK_DEBIAN_BMI_PACKAGE_DEPENDS "fumon-data (= ${PROJECT_VERSION}-${revision})")
    set(CPACK_COMPONENT_BMI_DESCRIPTION "models of fumon for programs that couple models
Sand and water landforms as components of the Basic Model Interface: the
library libfumonbmi, its headers, and what pkg-config and CMake find it by.")
endif()

if(FUMON_PYTHON_MODULE)
    list(APPEND CPACK_COMPONENTS_ALL python)
    set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-fumon)
    set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
    set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
    math(EXPR next "${Python_VERSION_MINOR} + 1")
    string(CONCAT CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
           "fumon-data (= ${PROJECT_VERSION}-${revision}), ${by_name}, python3-numpy, "
           "python3 (>= 3.${Python_VERSION_MINOR}), python3 (<< 3.${next})")
    set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-xarray, python3-pytest")
    set(CPACK_COMPONENT_PYTHON_DESCRIPTION "Python module of fumon
Scenes of sand and water landforms, run and drawn from Python: NumPy views
of beds, pictures of anyone's terrain, movies, sweeps as xarray Datasets,
and every model as a component of the Basic Model Interface.")
endif()

# What each kind of package needs besides: of Debian's compressed manual pages, a copyright file and a changelog; of the sources
# their licences.
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/packages_debian.cmake)

set(CPACK_SOURCE_GENERATOR TXZ)
set(CPACK_SOURCE_PACKAGE_FILE_NAME fumon-${PROJECT_VERSION})
string(REGEX REPLACE "([][+.*()^$?|\\\\])" "\\\\\\1" here "${CMAKE_SOURCE_DIR}")
set(CPACK_SOURCE_IGNORE_FILES "^${here}/(build|out|[.]git|[.]cache|src/python/build)/" "/__pycache__/" "[.]egg-info/" "[.]part$"
    "/compile_commands[.]json$")

include(CPack)
