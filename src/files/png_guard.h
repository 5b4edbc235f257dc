#pragma once

#include <png.h>

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstddef>
#include <cstring>

namespace fumon {

/// What libpng said when it gave up.
struct PngFailure {
    std::array<char, 160> message{};
};

/// The error function to give to libpng, together with a PngFailure.
[[noreturn]] inline void remember_png_failure(png_structp png, png_const_charp message) {
    auto* failure = static_cast<PngFailure*>(png_get_error_ptr(png));
    const std::size_t length = std::min(std::strlen(message), failure->message.size() - 1);
    std::copy_n(message, length, failure->message.begin());
    failure->message[length] = '\0';
    png_longjmp(png, 1);
}

inline void ignore_png_warning(png_structp /*png*/, png_const_charp /*message*/) {}

/// Calls work() and says whether it ended without an error of libpng's. libpng reports errors by
/// longjmp, which skips destructors: work may call libpng only while no object with a destructor
/// lives inside it.
template <class Work>
bool ends_without_png_error(png_structp png, const Work& work) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;  // NOLINT(cert-err52-cpp)
    work();
    return true;
}

}  // namespace fumon
