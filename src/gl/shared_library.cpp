#include "gl/shared_library.h"

#include <dlfcn.h>

namespace fumon::gl {

SharedLibrary::SharedLibrary(std::initializer_list<const char*> names) {
    for (const char* name : names) {
        handle_ = dlopen(name, RTLD_NOW | RTLD_LOCAL);
        if (handle_ != nullptr) return;
        const char* reason = dlerror();
        if (!failure_.empty()) failure_ += "; ";
        failure_ += reason != nullptr ? reason : name;
    }
}

void* SharedLibrary::symbol(const char* name) const {
    return handle_ != nullptr ? dlsym(handle_, name) : nullptr;
}

}  // namespace fumon::gl
