#include "files/gdal/gdal_functions.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include "base/error.h"

namespace fumon {

namespace {

/// The newest of the libraries that are installed, whose C interface all have what is in use.
void* open_library() {
    constexpr int newest = 37;  // GDAL 3.11; Debian 13 has 36 (3.10), Debian 12 has 32 (3.6)
    constexpr int oldest = 31;  // GDAL 3.5
    for (int number = newest; number >= oldest; --number) {
        void* const library =
            dlopen(fmt::format("libgdal.so.{}", number).c_str(), RTLD_NOW | RTLD_LOCAL);
        if (library != nullptr) return library;
    }
    return nullptr;
}

void* library() {
    static void* const opened = open_library();
    return opened;
}

}  // namespace

void* GdalFunctions::address_of(const char* name) {
    if (library() == nullptr) throw InputError(missing_gdal());
    void* const address = dlsym(library(), name);
    if (address == nullptr)
        throw Error(fmt::format("the GDAL that is installed lacks the function {}", name));
    return address;
}

const GdalFunctions& gdal() {
    static const GdalFunctions functions;
    return functions;
}

bool has_gdal() {
    return library() != nullptr;
}

std::string missing_gdal() {
    if (has_gdal()) return {};
    return "needs GDAL, which is not installed: apt-get install libgdal32 (Debian 12), libgdal36 "
           "(Debian 13) or libgdal34t64 (Ubuntu 24.04)";
}

}  // namespace fumon
