#include "gl/shared_library.h"

#include <dlfcn.h>

namespace fumon::gl {

SharedLibrary::SharedLibrary(std::span<const char* const> names) {
    for (const char* name : names) {
        handle_ = dlopen(name, RTLD_NOW | RTLD_LOCAL);
        if (handle_ != nullptr) return;
        const char* message = dlerror();
        const std::string reason = message != nullptr ? message : name;
        if (failure_.find(reason) != std::string::npos) continue;  // what they need is what fails
        if (!failure_.empty()) failure_ += "; ";
        failure_ += reason;
    }
}

void* SharedLibrary::symbol(const char* name) const {
    return handle_ != nullptr ? dlsym(handle_, name) : nullptr;
}

}  // namespace fumon::gl
