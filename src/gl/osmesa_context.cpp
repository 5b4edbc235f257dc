#include <fmt/format.h>

#include <array>
#include <cstdint>

#include "base/error.h"
#include "gl/backends.h"
#include "gl/functions.h"
#include "gl/library_names.h"
#include "gl/shared_library.h"

namespace fumon::gl {

namespace {

// The few declarations of OSMesa that are used: its header is gone from newer systems, and clashes
// with GL/glcorearb.h.
using OSMesaContext = struct OpaqueOSMesaContext*;
using CreateContextAttribs = OSMesaContext (*)(const int* attributes, OSMesaContext share);
using MakeCurrent = GLboolean (*)(OSMesaContext, void* buffer, GLenum type, GLsizei width,
                                  GLsizei height);
using DestroyContext = void (*)(OSMesaContext);
using GetProcAddress = void (*(*)(const char*))();
constexpr int osmesa_format = 0x22;
constexpr int osmesa_profile = 0x33;
constexpr int osmesa_core_profile = 0x34;
constexpr int osmesa_major_version = 0x36;
constexpr int osmesa_minor_version = 0x37;

constexpr const char* osmesa_advice = "install the Debian package libosmesa6";

struct OsMesaLibrary {
    SharedLibrary file{osmesa_names};
    CreateContextAttribs create = nullptr;
    MakeCurrent make_current = nullptr;
    DestroyContext destroy = nullptr;
    GetProcAddress resolve = nullptr;

    OsMesaLibrary() {
        create = reinterpret_cast<decltype(create)>(file.symbol("OSMesaCreateContextAttribs"));
        make_current = reinterpret_cast<decltype(make_current)>(file.symbol("OSMesaMakeCurrent"));
        destroy = reinterpret_cast<decltype(destroy)>(file.symbol("OSMesaDestroyContext"));
        resolve = reinterpret_cast<decltype(resolve)>(file.symbol("OSMesaGetProcAddress"));
    }
    [[nodiscard]] bool complete() const {
        return create != nullptr && make_current != nullptr && destroy != nullptr &&
               resolve != nullptr;
    }
};

const OsMesaLibrary& osmesa_library() {
    static const OsMesaLibrary loaded;
    return loaded;
}

class OsmesaContext final : public Context {
  public:
    explicit OsmesaContext(OSMesaContext handle) : handle_(handle) {
        bind();
        functions_ = resolve_functions([](const char* name) {
            return reinterpret_cast<void*>(osmesa_library().resolve(name));
        });
        set_functions(&functions_);
    }
    ~OsmesaContext() override {
        set_functions(nullptr);
        if (drivers_are_abandoned()) return;
        osmesa_library().make_current(nullptr, nullptr, 0, 0, 0);
        osmesa_library().destroy(handle_);
    }
    void make_current() override {
        bind();
        set_functions(&functions_);
    }
    [[nodiscard]] std::string backend_name() const override { return "osmesa"; }

  private:
    void bind() {
        if (osmesa_library().make_current(handle_, pixel_.data(), GL_UNSIGNED_BYTE, 1, 1) == 0) {
            throw Error("OSMesa refuses to make its context current");
        }
    }

    OSMesaContext handle_;
    std::array<std::uint8_t, 4>
        pixel_{};  // OSMesa wants a buffer; frames go to framebuffer objects
    Functions functions_;
};

}  // namespace

Attempt try_osmesa() {
    const OsMesaLibrary& mesa = osmesa_library();
    if (!mesa.file.loaded())
        return {nullptr, fmt::format("OSMesa: {} ({})", mesa.file.failure(), osmesa_advice)};
    if (!mesa.complete()) {
        return {nullptr, fmt::format("OSMesa: the library lacks OSMesaCreateContextAttribs ({} "
                                     "12.0 or newer)",
                                     osmesa_advice)};
    }
    const std::array<int, 9> attributes = {osmesa_profile,
                                           osmesa_core_profile,
                                           osmesa_major_version,
                                           3,
                                           osmesa_minor_version,
                                           3,
                                           osmesa_format,
                                           GL_RGBA,
                                           0};
    OSMesaContext handle = mesa.create(attributes.data(), nullptr);
    if (handle == nullptr)
        return {nullptr, "OSMesa: it offers no OpenGL 3.3 core profile (Mesa 12.0 or newer does)"};
    try {
        return {std::make_unique<OsmesaContext>(handle), {}};
    } catch (const Error& error) {
        return {nullptr, fmt::format("OSMesa: {}", error.what())};
    }
}

}  // namespace fumon::gl
