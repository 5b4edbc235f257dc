#include "picture/encoder_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/elementary_power.h"

namespace fumon {

namespace {

/// A rate factor of H.264 as one of a scale of its own, about as good to look at.
int scaled(int quality, int highest) {
    return std::clamp((quality * highest + 25) / 51, 0, highest);
}

}  // namespace

int h264_kilobits(const MovieSize& size, int quality) {
    constexpr double usual_pixels = 1920.0 * 1080.0 * 30.0;
    constexpr double usual_kilobits = 16000.0;
    constexpr double least = 2000.0;
    constexpr double most = 800000.0;  // of the highest level
    constexpr double usual_quality = 18.0;
    constexpr double halving = 6.0;
    const double pixels = static_cast<double>(size.width) * size.height * size.rate;
    const double kilobits = usual_kilobits * elementary::pow(pixels / usual_pixels, 0.75) *
                            elementary::pow(2.0, (usual_quality - quality) / halving);
    return static_cast<int>(std::lround(std::clamp(kilobits, least, most)));
}

std::vector<std::pair<std::string, std::string>> encoder_options(const MovieFormat& format,
                                                                 const MovieSize& size, int quality,
                                                                 bool quickly) {
    const std::string crf = fmt::format("{}", quality);
    if (format.name == "h264") {
        // The same choices whatever instructions the processor has; even parts get bits enough to
        // keep the dither of the sky, without which it shows bands.
        return {{"preset", quickly ? "ultrafast" : "veryfast"},
                {"crf", crf},
                {"x264-params",
                 fmt::format("cpu-independent=1:aq-mode=3:aq-strength=1.7:deadzone-inter=4:"
                             "deadzone-intra=4:no-dct-decimate=1:deblock=-2,-2:vbv-maxrate={0}:"
                             "vbv-bufsize={0}",
                             h264_kilobits(size, quality))}};
    }
    if (format.name == "hevc") {
        return {{"preset", "fast"},
                {"crf", crf},
                {"x265-params", "pools=2:frame-threads=1:wpp=1:log-level=none:info=0"},
                {"tag", "hvc1"}};
    }
    if (format.name == "av1")
        return {{"preset", "8"}, {"crf", fmt::format("{}", scaled(quality, 63))}};
    if (format.name == "webm") {
        return {{"b", "0"},
                {"crf", fmt::format("{}", scaled(quality, 63))},
                {"deadline", "good"},
                {"cpu-used", "4"},
                {"row-mt", "1"}};
    }
    if (format.name == "prores") return {{"profile", "4444"}, {"vendor", "fumo"}};
    if (format.name == "ffv1") return {{"level", "3"}, {"slices", "4"}, {"slicecrc", "1"}};
    if (format.name == "webp")
        return {{"quality", fmt::format("{}", 100 - quality)}, {"compression_level", "4"}};
    return {};
}

}  // namespace fumon
