#include "picture/movie_pixels.h"

extern "C" {
#include <libavutil/frame.h>
}

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "picture/colour_table.h"

namespace fumon {

void copy_padded_open(const Image& image, AVFrame& frame) {
    for (int y = 0; y < frame.height; ++y) {
        const int from = std::min(y, image.height - 1);
        const std::uint8_t* colours = image.row(from);
        const std::uint8_t* alpha = image.alpha.data() + static_cast<std::size_t>(from) *
                                                             static_cast<std::size_t>(image.width);
        std::uint8_t* target = frame.data[0] + static_cast<std::ptrdiff_t>(y) * frame.linesize[0];
        for (int x = 0; x < frame.width; ++x) {
            const int column = std::min(x, image.width - 1);
            target = std::copy_n(colours + std::ptrdiff_t{3} * column, 3, target);
            *target++ = alpha[column];
        }
    }
}

void copy_padded(const Image& image, AVFrame& frame) {
    const auto row_bytes = static_cast<std::size_t>(3) * static_cast<std::size_t>(image.width);
    for (int y = 0; y < frame.height; ++y) {
        const std::uint8_t* source = image.row(std::min(y, image.height - 1));
        std::uint8_t* target = frame.data[0] + static_cast<std::ptrdiff_t>(y) * frame.linesize[0];
        std::memcpy(target, source, row_bytes);
        if (frame.width > image.width) std::memcpy(target + row_bytes, source + row_bytes - 3, 3);
    }
}

void copy_indexed(const Image& image, const ColourTable& colours, AVFrame& frame) {
    const std::vector<std::uint8_t> indices = colours.indices(image);
    const auto width = static_cast<std::size_t>(image.width);
    for (int y = 0; y < image.height; ++y)
        std::memcpy(frame.data[0] + static_cast<std::ptrdiff_t>(y) * frame.linesize[0],
                    indices.data() + static_cast<std::size_t>(y) * width, width);
    std::memcpy(frame.data[1], colours.colours().data(), sizeof(colours.colours()));
}

}  // namespace fumon
