#include "gl/context.h"

#include <fmt/format.h>

#include <atomic>

#include "base/error.h"
#include "gl/backends.h"
#include "gl/functions.h"

namespace fumon::gl {

namespace {

std::atomic<bool> asked_for = false;

std::string text_of(GLenum name) {
    const GLubyte* text = functions().GetString(name);
    return text != nullptr ? reinterpret_cast<const char*>(text) : "unknown";
}

}  // namespace

std::unique_ptr<Context> Context::create(Backend backend) {
    asked_for = true;
    std::string failures;
    if (backend != Backend::egl) {
        Attempt attempt = try_osmesa();
        if (attempt.context) return std::move(attempt.context);
        failures = std::move(attempt.failure);
    }
    if (backend != Backend::osmesa) {
        Attempt attempt = try_egl();
        if (attempt.context) return std::move(attempt.context);
        if (!failures.empty()) failures += "; ";
        failures += attempt.failure;
    }
    throw Error(fmt::format("no OpenGL 3.3 without a display: {}", failures));
}

bool Context::any_created() {
    return asked_for;
}

std::string Context::renderer_name() const {
    return text_of(GL_RENDERER);
}
std::string Context::version() const {
    return text_of(GL_VERSION);
}

}  // namespace fumon::gl
