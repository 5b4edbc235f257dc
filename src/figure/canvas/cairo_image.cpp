#include "figure/canvas/cairo_image.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <vector>

#include "base/error.h"

namespace fumon {

Surface cairo_image(const Image& image, std::span<const std::uint8_t> opacity, int copies) {
    const bool opaque = opacity.empty();
    Surface surface(cairo_image_surface_create(opaque ? CAIRO_FORMAT_RGB24 : CAIRO_FORMAT_ARGB32,
                                               copies * image.width, copies * image.height));
    if (cairo_surface_status(surface.get()) != CAIRO_STATUS_SUCCESS)
        throw Error(fmt::format("cannot draw an image of {} x {} pixels into a figure: {}",
                                image.width, image.height,
                                cairo_status_to_string(cairo_surface_status(surface.get()))));
    unsigned char* pixels = cairo_image_surface_get_data(surface.get());
    const int stride = cairo_image_surface_get_stride(surface.get());
    std::vector<std::uint32_t> line(static_cast<std::size_t>(copies) *
                                    static_cast<std::size_t>(image.width));
    std::size_t n = 0;
    for (int y = 0; y < image.height; ++y) {
        const std::uint8_t* in = image.row(y);
        auto out = line.begin();
        for (int x = 0; x < image.width; ++x, ++n) {
            const std::uint32_t alpha = opaque ? 255U : opacity[n];
            std::uint32_t pixel = alpha;
            for (int c = 0; c < 3; ++c) pixel = (pixel << 8U) | ((*in++ * alpha + 127U) / 255U);
            out = std::fill_n(out, copies, pixel);
        }
        for (int copy = 0; copy < copies; ++copy)
            std::memcpy(pixels + std::ptrdiff_t{stride} * (std::ptrdiff_t{copies} * y + copy),
                        line.data(), 4 * line.size());
    }
    cairo_surface_mark_dirty(surface.get());
    return surface;
}

Image image_of_cairo(cairo_surface_t* surface) {
    cairo_surface_flush(surface);
    Image image(cairo_image_surface_get_width(surface), cairo_image_surface_get_height(surface));
    const unsigned char* pixels = cairo_image_surface_get_data(surface);
    const int stride = cairo_image_surface_get_stride(surface);
    for (int y = 0; y < image.height; ++y) {
        std::uint8_t* out = image.row(y);
        for (int x = 0; x < image.width; ++x) {
            std::uint32_t pixel = 0;
            std::memcpy(&pixel, pixels + std::ptrdiff_t{stride} * y + std::ptrdiff_t{4} * x, 4);
            *out++ = static_cast<std::uint8_t>(pixel >> 16U);
            *out++ = static_cast<std::uint8_t>(pixel >> 8U);
            *out++ = static_cast<std::uint8_t>(pixel);
        }
    }
    return image;
}

}  // namespace fumon
