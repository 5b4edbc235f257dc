#pragma once

#include <string>

namespace fumon {

/// The software that drew a picture, as far as its pixels depend on it.
struct RenderingEnvironment {
    std::string backend;       ///< "osmesa", "egl", or "cairo" for flat figures; empty: unknown
    std::string renderer;      ///< GL_RENDERER, or the libraries of flat figures
    std::string gl_version;    ///< GL_VERSION; empty without OpenGL
    std::string mesa_version;  ///< "22.3.6"; empty where Mesa did not draw
    std::string llvm_version;  ///< "15.0.6"; empty where llvmpipe did not draw
    bool pinned = false;       ///< drawn under gl::pin_rendering(), without text
    friend bool operator==(const RenderingEnvironment&, const RenderingEnvironment&) = default;
};

/// The environment of an OpenGL context, with the versions that its names tell
/// ("4.5 (Core Profile) Mesa 22.3.6", "llvmpipe (LLVM 15.0.6, 256 bits)").
RenderingEnvironment opengl_environment(const std::string& backend, const std::string& renderer,
                                        const std::string& gl_version, bool pinned);

/// What differs, for a person ("Mesa 22.3.6 there, 24.0.1 here"), by commas; empty where they are
/// equal.
std::string difference(const RenderingEnvironment& there, const RenderingEnvironment& here);

/// Why the same scene need not have the same pixels in both: what differs, or that one of them is
/// not pinned, so that its pixels depend on the processor. Empty where the pixels must be equal.
/// That OSMesa drew the one and EGL the other is no reason: both lead to the same llvmpipe.
std::string why_pixels_may_differ(const RenderingEnvironment& there,
                                  const RenderingEnvironment& here);

/// As one line of JSON, for a picture's metadata.
std::string environment_text(const RenderingEnvironment& environment);
/// Reads it back; fields that are missing stay empty. Throws InputError where it is no JSON object.
RenderingEnvironment parse_environment(const std::string& text);

}  // namespace fumon
