#include "gl/pinned.h"

#include <fmt/format.h>

#include <array>
#include <cstdlib>

#include "base/error.h"
#include "gl/context.h"

namespace fumon::gl {

namespace {

struct Setting {
    const char* variable;
    const char* value;
};

/// Of llvmpipe; the vector width is the one that follows from the processor's level.
constexpr std::array pinned_settings = {
    Setting{"GALLIUM_OVERRIDE_CPU_CAPS", "sse4.1"}, Setting{"LP_NATIVE_VECTOR_WIDTH", "128"},
    Setting{"LP_NUM_THREADS", "4"}, Setting{"GALLIUM_DRIVER", "llvmpipe"},
    Setting{"LIBGL_ALWAYS_SOFTWARE", "1"}};

/// Switches of Mesa that change what it draws, or what draws.
constexpr std::array removed_variables = {"DRAW_USE_LLVM",
                                          "GALLIUM_HUD",
                                          "GALLIUM_NOOP",
                                          "GALLIUM_NOSSE",
                                          "GALLIVM_DEBUG",
                                          "GALLIVM_PERF",
                                          "LP_CL",
                                          "LP_DEBUG",
                                          "LP_NO_RAST",
                                          "LP_PERF",
                                          "MESA_DEBUG",
                                          "MESA_EXTENSION_OVERRIDE",
                                          "MESA_GLSL",
                                          "MESA_GLSL_VERSION_OVERRIDE",
                                          "MESA_GL_VERSION_OVERRIDE",
                                          "MESA_LOADER_DRIVER_OVERRIDE",
                                          "MESA_SHADER_READ_PATH",
                                          "ST_DEBUG"};

struct Pinning {
    bool done = false;
    std::vector<std::string> overridden;
};

Pinning& pinning() {
    static Pinning state;
    return state;
}

}  // namespace

// The environment is changed before any other thread runs.
// NOLINTBEGIN(concurrency-mt-unsafe)
void pin_rendering() {
    Pinning& state = pinning();
    if (state.done) return;
    if (Context::any_created())
        throw Error("rendering can no longer be pinned: an OpenGL context already exists");
    for (const Setting& setting : pinned_settings) {
        const char* before = std::getenv(setting.variable);
        if (before != nullptr && std::string(before) != setting.value) {
            state.overridden.push_back(
                fmt::format("{}={} is overridden: {}", setting.variable, before, setting.value));
        }
        setenv(setting.variable, setting.value, 1);
    }
    for (const char* variable : removed_variables) {
        const char* before = std::getenv(variable);
        if (before == nullptr) continue;
        state.overridden.push_back(fmt::format("{}={} is overridden: unset", variable, before));
        unsetenv(variable);
    }
    state.done = true;
}
// NOLINTEND(concurrency-mt-unsafe)

bool rendering_is_pinned() {
    return pinning().done;
}

const std::vector<std::string>& overridden_by_pinning() {
    return pinning().overridden;
}

std::string pinning_obstacle([[maybe_unused]] const std::string& renderer) {
#if !defined(__x86_64__)
    return "the processor is not x86-64";
#else
    if (!renderer.starts_with("llvmpipe"))
        return fmt::format("{} draws it, not Mesa's llvmpipe", renderer);
    // Without it llvmpipe multiplies the bytes of textures in another rounding.
    if (__builtin_cpu_supports("sse4.1") == 0)
        return "pinned pictures need SSE4.1 (processors from 2008 on), which this processor lacks";
    return {};
#endif
}

}  // namespace fumon::gl
