#pragma once

#include <array>

namespace fumon::gl {

// What the libraries that draw are called, each by the names that are tried.

#ifdef __APPLE__
inline constexpr std::array<const char*, 2> osmesa_names{"libOSMesa.8.dylib", "libOSMesa.dylib"};
inline constexpr std::array<const char*, 2> egl_names{"libEGL.1.dylib", "libEGL.dylib"};
#else
inline constexpr std::array<const char*, 3> osmesa_names{"libOSMesa.so.8", "libOSMesa.so.6",
                                                         "libOSMesa.so"};
inline constexpr std::array<const char*, 1> egl_names{"libEGL.so.1"};
#endif

}  // namespace fumon::gl
