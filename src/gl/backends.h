#pragma once

#include <memory>
#include <string>

#include "gl/context.h"

namespace fumon::gl {

/// Either a context, made current, or the reason why there is none, with the package that helps.
struct Attempt {
    std::unique_ptr<Context> context;
    std::string failure;
};

/// A core profile 3.3 context by OSMesaCreateContextAttribs, drawing into framebuffer objects.
Attempt try_osmesa();

/// A core profile 3.3 context without a surface, on EGL's surfaceless platform, then on each
/// device.
Attempt try_egl();

}  // namespace fumon::gl
