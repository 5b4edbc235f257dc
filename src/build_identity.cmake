# Which program a build makes: SHA-256 over its sources, by their names and bytes, wherever they lie. CMakeLists.txt includes
# this for the list of them, and a build runs it, which writes ${TO}:
#   cmake -D ROOT=folder-of-the-sources -D TOOLS=compiler-and-flags -D TO=file.cpp -P build_identity.cmake

# fumon_sources(ROOT VARIABLE): everything that decides what the program computes and draws.
function(fumon_sources root variable)
    set(watched CONFIGURE_DEPENDS)
    if(CMAKE_SCRIPT_MODE_FILE)
        set(watched "")
    endif()
    file(GLOB_RECURSE sources ${watched} RELATIVE ${root}
         ${root}/src/*.cpp ${root}/src/*.h ${root}/shaders/* ${root}/assets/palettes/*.txt ${root}/assets/fonts/*.txt)
    list(APPEND sources CMakeLists.txt src/CMakeLists.txt)
    list(FILTER sources EXCLUDE REGEX "^src/python")  # which computes and draws nothing itself
    list(SORT sources)
    set(${variable} ${sources} PARENT_SCOPE)
endfunction()

if(CMAKE_SCRIPT_MODE_FILE)
    fumon_sources(${ROOT} sources)
    set(all "")
    foreach(source IN LISTS sources)
        file(SHA256 ${ROOT}/${source} hash)
        string(APPEND all "${hash} ${source}\n")
    endforeach()
    string(SHA256 identity "${all}")
    file(CONFIGURE OUTPUT ${TO} @ONLY CONTENT [==[
#include "run/build_identity.h"

namespace fumon {

const BuildIdentity& this_build() {
    static const BuildIdentity build{"@identity@", R"(@TOOLS@)"};
    return build;
}

}  // namespace fumon
]==])
endif()
