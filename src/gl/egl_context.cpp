#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <fmt/format.h>

#include <array>
#include <vector>

#include "base/error.h"
#include "gl/backends.h"
#include "gl/functions.h"
#include "gl/library_names.h"
#include "gl/shared_library.h"

namespace fumon::gl {

namespace {

constexpr const char* egl_advice = "install the Debian packages libegl1 and libgl1-mesa-dri";

struct EglLibrary {
    SharedLibrary file{egl_names};
    PFNEGLGETPROCADDRESSPROC resolve = nullptr;
    PFNEGLGETPLATFORMDISPLAYPROC platform_display = nullptr;
    PFNEGLINITIALIZEPROC initialize = nullptr;
    PFNEGLBINDAPIPROC bind_api = nullptr;
    PFNEGLCHOOSECONFIGPROC choose_config = nullptr;
    PFNEGLCREATECONTEXTPROC create_context = nullptr;
    PFNEGLMAKECURRENTPROC make_current = nullptr;
    PFNEGLDESTROYCONTEXTPROC destroy_context = nullptr;
    PFNEGLQUERYDEVICESEXTPROC query_devices = nullptr;

    EglLibrary() {
        if (!file.loaded()) return;
        find(resolve, "eglGetProcAddress");
        find(initialize, "eglInitialize");
        find(bind_api, "eglBindAPI");
        find(choose_config, "eglChooseConfig");
        find(create_context, "eglCreateContext");
        find(make_current, "eglMakeCurrent");
        find(destroy_context, "eglDestroyContext");
        if (resolve == nullptr) return;
        platform_display =
            reinterpret_cast<PFNEGLGETPLATFORMDISPLAYPROC>(resolve("eglGetPlatformDisplay"));
        query_devices = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(resolve("eglQueryDevicesEXT"));
    }
    [[nodiscard]] bool complete() const {
        return resolve != nullptr && platform_display != nullptr && initialize != nullptr &&
               bind_api != nullptr && choose_config != nullptr && create_context != nullptr &&
               make_current != nullptr && destroy_context != nullptr;
    }

  private:
    template <class Function>
    void find(Function& function, const char* name) {
        function = reinterpret_cast<Function>(file.symbol(name));
    }
};

const EglLibrary& egl_library() {
    static const EglLibrary loaded;
    return loaded;
}

class EglContext final : public Context {
  public:
    // The display stays initialised: other contexts of the process may share it.
    EglContext(EGLDisplay display, EGLContext handle) : display_(display), handle_(handle) {
        try {
            bind();
            functions_ = resolve_functions(
                // NOLINTNEXTLINE(clang-analyzer-core.CallAndMessage): complete() was asked before
                [](const char* name) {
                    return reinterpret_cast<void*>(egl_library().resolve(name));
                });
        } catch (...) {
            egl_library().destroy_context(display_, handle_);
            throw;
        }
        set_functions(&functions_);
    }
    ~EglContext() override {
        set_functions(nullptr);
        if (drivers_are_abandoned()) return;
        egl_library().make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        egl_library().destroy_context(display_, handle_);
    }
    void make_current() override {
        bind();
        set_functions(&functions_);
    }
    [[nodiscard]] std::string backend_name() const override { return "egl"; }

  private:
    void bind() {
        // NOLINTNEXTLINE(clang-analyzer-core.CallAndMessage): complete() was asked before
        if (egl_library().make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, handle_) ==
            EGL_FALSE)
            throw Error("it refuses to make a context current without a surface");
    }

    EGLDisplay display_;
    EGLContext handle_;
    Functions functions_;
};

std::vector<EGLDisplay> displays() {
    const EglLibrary& egl = egl_library();
    std::vector<EGLDisplay> found;
    if (!egl.complete()) return found;
    const auto add = [&](EGLDisplay display) {
        if (display != EGL_NO_DISPLAY) found.push_back(display);
    };
    add(egl.platform_display(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr));
    if (egl.query_devices != nullptr) {
        std::array<EGLDeviceEXT, 16> devices{};
        EGLint count = 0;
        if (egl.query_devices(static_cast<EGLint>(devices.size()), devices.data(), &count) !=
            EGL_FALSE) {
            for (EGLint i = 0; i < count; ++i) {
                add(egl.platform_display(EGL_PLATFORM_DEVICE_EXT,
                                         devices[static_cast<std::size_t>(i)], nullptr));
            }
        }
    }
    return found;
}

EGLContext core_context(EGLDisplay display) {
    const EglLibrary& egl = egl_library();
    if (egl.initialize(display, nullptr, nullptr) == EGL_FALSE) return EGL_NO_CONTEXT;
    if (egl.bind_api(EGL_OPENGL_API) == EGL_FALSE) return EGL_NO_CONTEXT;
    const std::array<EGLint, 5> wanted = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                                          EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (egl.choose_config(display, wanted.data(), &config, 1, &count) == EGL_FALSE || count == 0)
        config = EGL_NO_CONFIG_KHR;
    const std::array<EGLint, 7> attributes = {EGL_CONTEXT_MAJOR_VERSION,
                                              3,
                                              EGL_CONTEXT_MINOR_VERSION,
                                              3,
                                              EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                              EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                              EGL_NONE};
    return egl.create_context(display, config, EGL_NO_CONTEXT, attributes.data());
}

}  // namespace

Attempt try_egl() {
    const EglLibrary& egl = egl_library();
    if (!egl.file.loaded())
        return {nullptr, fmt::format("EGL: {} ({})", egl.file.failure(), egl_advice)};
    if (!egl.complete())
        return {nullptr, fmt::format("EGL: the library is older than EGL 1.5 ({})", egl_advice)};
    std::string failure = "no surfaceless platform and no device";
    for (EGLDisplay display : displays()) {
        EGLContext handle = core_context(display);
        if (handle == EGL_NO_CONTEXT) {
            failure = "neither the surfaceless platform nor a device offers OpenGL 3.3 core";
            continue;
        }
        try {
            return {std::make_unique<EglContext>(display, handle), {}};
        } catch (const Error& error) {
            failure = error.what();
        }
    }
    return {nullptr, fmt::format("EGL: {} ({})", failure, egl_advice)};
}

}  // namespace fumon::gl
