#include "picture/libav_functions.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <array>
#include <cstddef>

#include "base/error.h"

namespace fumon {

namespace {

constexpr std::array library_names{FUMON_LIBAV_LIBRARIES};
using Libraries = std::array<void*, library_names.size()>;

Libraries loaded_libraries() {
    Libraries loaded{};
    for (std::size_t i = 0; i < loaded.size(); ++i) {
        loaded[i] = dlopen(library_names[i], RTLD_NOW | RTLD_LOCAL);
        if (loaded[i] != nullptr) continue;
        const char* why = dlerror();
        throw Error(fmt::format(
            "FFmpeg, which movies need, cannot be loaded: {}; install it (on Debian {})",
            why == nullptr ? library_names[i] : why, FUMON_LIBAV_PACKAGES));
    }
    return loaded;
}

}  // namespace

void* LibavFunctions::address_of(const char* name) {
    static const Libraries libraries = loaded_libraries();
    for (void* library : libraries) {
        void* const address = dlsym(library, name);
        if (address != nullptr) return address;
    }
    throw Error(fmt::format("FFmpeg, which movies need, lacks the function {}", name));
}

const LibavFunctions& libav() {
    static const LibavFunctions functions;
    return functions;
}

}  // namespace fumon
