// In the place of osmesa_context.cpp or egl_context.cpp where fumon is built without one of them.

#include "gl/backends.h"

namespace fumon::gl {

#ifndef FUMON_OSMESA
Attempt try_osmesa() {
    return {nullptr, "OSMesa: this fumon was built without it (-DFUMON_WITH_OSMESA=OFF)"};
}
#endif

#ifndef FUMON_EGL
Attempt try_egl() {
    return {nullptr, "EGL: this fumon was built without it (EGL/egl.h was missing, of libegl-dev)"};
}
#endif

}  // namespace fumon::gl
