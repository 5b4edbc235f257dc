#include "picture/pixels/ignored_pixels.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "files/hash.h"

namespace fumon {

namespace {

constexpr std::uint8_t blank = 128;                      // grey level
constexpr std::array<unsigned, 3> stripe{70, 120, 220};  // blue, which no mark of a difference is
constexpr int stripes_apart = 8;                         // pixels along a row
constexpr int stripe_width = 3;                          // pixels along a row

/// Calls work(x, y, number) for every ignored pixel.
template <class Work>
void for_each_ignored(const IgnoredPixels& ignored, const Work& work) {
    std::size_t number = 0;
    for (int y = 0; y < ignored.height; ++y) {
        for (int x = 0; x < ignored.width; ++x, ++number) {
            if (ignored.flags[number] != 0) work(x, y, number);
        }
    }
}

}  // namespace

std::int64_t IgnoredPixels::count() const {
    return std::count(flags.begin(), flags.end(), std::uint8_t{1});
}

double IgnoredPixels::share() const {
    if (!any()) return 0.0;
    return static_cast<double>(count()) / static_cast<double>(flags.size());
}

std::string IgnoredPixels::hash() const {
    if (!any()) return {};
    Sha256Stream stream;
    const std::array<std::int32_t, 2> size{width, height};
    stream.add(size.data(), sizeof size);
    stream.add(flags.data(), flags.size());
    return hex(stream.finish());
}

void IgnoredPixels::make_flags() {
    if (flags.empty())
        flags.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
}

void IgnoredPixels::add(const PixelBox& box) {
    // Of numbers up to 2^62 no sum is beyond 2^63.
    const auto left = std::clamp<std::int64_t>(box.x, 0, width);
    const auto right = std::clamp<std::int64_t>(box.x + box.width, left, width);
    const auto top = std::clamp<std::int64_t>(box.y, 0, height);
    const auto bottom = std::clamp<std::int64_t>(box.y + box.height, top, height);
    if (left == right || top == bottom) return;
    make_flags();
    for (std::int64_t y = top; y < bottom; ++y)
        std::fill_n(flags.begin() + (y * width + left), right - left, std::uint8_t{1});
}

void IgnoredPixels::add(const Image& mask) {
    for (std::size_t number = 0; 3 * number < mask.rgb.size(); ++number) {
        const std::uint8_t* pixel = &mask.rgb[3 * number];
        if ((77 * pixel[0] + 150 * pixel[1] + 29 * pixel[2]) >> 8 < 128) continue;
        make_flags();
        flags[number] = 1;
    }
}

Image blanked(const Image& image, const IgnoredPixels& ignored) {
    Image picture = image;
    if (!ignored.any()) return picture;
    for_each_ignored(ignored, [&](int /*x*/, int /*y*/, std::size_t number) {
        for (std::size_t at = 3 * number; at < 3 * number + 3; ++at) {
            picture.rgb[at] = blank;
            if (!picture.rgb16.empty())
                picture.rgb16[at] = static_cast<std::uint16_t>(257U * blank);
        }
        if (picture.transparent()) picture.alpha[number] = 255;
    });
    return picture;
}

Image hatched(const Image& image, const IgnoredPixels& ignored) {
    Image picture = image;
    picture.rgb16.clear();
    if (!ignored.any()) return picture;
    for_each_ignored(ignored, [&](int x, int y, std::size_t number) {
        const bool on_stripe = (x + y) % stripes_apart < stripe_width;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            std::uint8_t& level = picture.rgb[3 * number + channel];
            const unsigned parts = on_stripe ? 12 : 2;  // of 16, of the stripes' colour
            level =
                static_cast<std::uint8_t>((parts * stripe.at(channel) + (16 - parts) * level) / 16);
        }
        if (picture.transparent()) picture.alpha[number] = 255;
    });
    return picture;
}

}  // namespace fumon
