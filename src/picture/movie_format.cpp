#include "picture/movie_format.h"

#include <array>

#include "base/find_named.h"

namespace fumon {

namespace {

constexpr std::array<MovieFormat, 9> formats{{
    {"h264", ".mp4", "mp4", "libx264", "yuv420p", "", true,
     "MP4 with H.264, which plays everywhere"},
    {"hevc", ".mp4", "mp4", "libx265", "yuv420p10le", "", true, "MP4 with HEVC, 10 bits"},
    {"av1", ".mp4", "mp4", "libsvtav1", "yuv420p10le", "", true, "MP4 with AV1, 10 bits"},
    {"webm", ".webm", "webm", "libvpx-vp9", "yuv420p", "yuva420p", true,
     "WebM with VP9, for web pages"},
    {"prores", ".mov", "mov", "prores_ks", "yuva444p10le", "yuva444p10le", true,
     "QuickTime with ProRes 4444, for editors"},
    {"ffv1", ".mkv", "matroska", "ffv1", "bgr0", "bgra", false, "Matroska with FFV1, lossless"},
    {"webp", ".webp", "webp", "libwebp_anim", "yuv420p", "bgra", false,
     "animated WebP, for web pages"},
    {"gif", ".gif", "gif", "gif", "pal8", "", false, "GIF with a palette of the whole film"},
    {"apng", ".apng", "apng", "apng", "rgb24", "rgba", false, "animated PNG, lossless"},
}};

}  // namespace

std::span<const MovieFormat> movie_formats() {
    return formats;
}

const MovieFormat* find_movie_format(std::string_view name) {
    return find_named(formats, name);
}

std::string transparent_format_names() {
    std::string names;
    for (const MovieFormat& format : formats)
        if (!format.open_pixels.empty())
            names += (names.empty() ? "" : ", ") + std::string(format.name);
    return names;
}

std::string movie_format_names() {
    std::string names;
    for (const MovieFormat& format : formats)
        names += (names.empty() ? "" : ", ") + std::string(format.name);
    return names;
}

}  // namespace fumon
