#pragma once

#include <memory>
#include <string>

namespace fumon::gl {

enum class Backend { automatic, osmesa, egl };

/// An off-screen OpenGL core context (3.3 or newer) without a display. OSMesa and EGL are loaded at
/// run time and neither is linked. A context belongs to the thread that made it.
class Context {
  public:
    /// Makes a context and makes it current. `automatic` takes OSMesa and, where that is missing,
    /// EGL (surfaceless, then a device). Throws Error naming what was tried and the package that
    /// would help.
    static std::unique_ptr<Context> create(Backend backend);
    /// Whether create() was ever called in this process.
    [[nodiscard]] static bool any_created();

    Context() = default;
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
    virtual ~Context() = default;

    /// Makes it the current context of this thread again, after another one was. Throws Error.
    virtual void make_current() = 0;

    [[nodiscard]] virtual std::string backend_name() const = 0;  ///< "osmesa" or "egl"
    [[nodiscard]] std::string renderer_name() const;  ///< GL_RENDERER of the current context
    [[nodiscard]] std::string version() const;        ///< GL_VERSION of the current context
};

}  // namespace fumon::gl
