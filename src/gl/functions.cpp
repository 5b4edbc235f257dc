#include "gl/functions.h"

#include <fmt/format.h>

#include <atomic>
#include <string_view>

#include "base/error.h"

namespace fumon::gl {

namespace {

thread_local const Functions* current = nullptr;
std::atomic<bool> abandoned = false;

std::string_view error_name(GLenum error) {
    switch (error) {
        case GL_INVALID_ENUM:
            return "invalid enumeration";
        case GL_INVALID_VALUE:
            return "invalid value";
        case GL_INVALID_OPERATION:
            return "invalid operation";
        case GL_INVALID_FRAMEBUFFER_OPERATION:
            return "invalid framebuffer operation";
        case GL_OUT_OF_MEMORY:
            return "out of memory";
        default:
            return "unknown error";
    }
}

}  // namespace

Functions resolve_functions(const std::function<void*(const char*)>& resolve) {
    Functions table;
    const auto find = [&](const char* name) {
        void* found = resolve(name);
        if (found == nullptr)
            throw Error(fmt::format("OpenGL 3.3 is needed: {} is missing from this library", name));
        return found;
    };
#define FUMON_GL_RESOLVE(name, type) table.name = reinterpret_cast<type>(find("gl" #name));
    FUMON_GL_FUNCTIONS(FUMON_GL_RESOLVE)
#undef FUMON_GL_RESOLVE
    return table;
}

const Functions& functions() {
    if (current == nullptr) throw Error("no OpenGL context is current on this thread");
    return *current;
}

void set_functions(const Functions* table) {
    current = table;
}

void check_errors(const char* where) {
    const GLenum error = functions().GetError();
    if (error == GL_NO_ERROR) return;
    while (functions().GetError() != GL_NO_ERROR) {
    }
    throw Error(fmt::format("OpenGL failed in {}: {} (0x{:04x})", where, error_name(error), error));
}

void abandon_drivers() noexcept {
    abandoned = true;
}

bool drivers_are_abandoned() noexcept {
    return abandoned;
}

}  // namespace fumon::gl
