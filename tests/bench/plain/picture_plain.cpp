#include "plain/picture_plain.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>

namespace fumon::plain {

namespace {

std::int64_t luminance(const std::uint8_t* pixel) {
    return 77 * pixel[0] + 150 * pixel[1] + 29 * pixel[2];
}

double similarity(const Image& first, const Image& second, int left, int top) {
    constexpr double c1 = (0.01 * 255 * 256.0) * (0.01 * 255 * 256.0);
    constexpr double c2 = (0.03 * 255 * 256.0) * (0.03 * 255 * 256.0);
    std::int64_t a = 0;
    std::int64_t b = 0;
    std::int64_t aa = 0;
    std::int64_t bb = 0;
    std::int64_t ab = 0;
    for (int y = top; y < top + 8; ++y) {
        for (int x = left; x < left + 8; ++x) {
            const std::int64_t p = luminance(first.row(y) + 3 * x);
            const std::int64_t q = luminance(second.row(y) + 3 * x);
            a += p;
            b += q;
            aa += p * p;
            bb += q * q;
            ab += p * q;
        }
    }
    const double mean_a = static_cast<double>(a) / 64.0;
    const double mean_b = static_cast<double>(b) / 64.0;
    const double variance_a = static_cast<double>(64 * aa - a * a) / (64.0 * 63.0);
    const double variance_b = static_cast<double>(64 * bb - b * b) / (64.0 * 63.0);
    const double covariance = static_cast<double>(64 * ab - a * b) / (64.0 * 63.0);
    return (2.0 * mean_a * mean_b + c1) * (2.0 * covariance + c2) /
           ((mean_a * mean_a + mean_b * mean_b + c1) * (variance_a + variance_b + c2));
}

}  // namespace

Compared compare(const Image& first, const Image& second) {
    Compared found;
    found.difference = Image(first.width, first.height);
    std::int64_t sum = 0;
    for (int y = 0; y < first.height; ++y) {
        for (int x = 0; x < first.width; ++x) {
            const std::uint8_t* p = first.row(y) + 3 * x;
            const std::uint8_t* q = second.row(y) + 3 * x;
            std::uint8_t* out = found.difference.row(y) + 3 * x;
            int largest = 0;
            for (int channel = 0; channel < 3; ++channel) {
                const int by = std::abs(p[channel] - q[channel]);
                largest = std::max(largest, by);
                sum += by;
            }
            found.comparison.largest = std::max(found.comparison.largest, largest);
            if (largest == 0) {
                std::fill_n(out, 3, static_cast<std::uint8_t>(luminance(p) / 1024));
                continue;
            }
            ++found.comparison.changed;
            out[0] = static_cast<std::uint8_t>(std::min(255, 120 + 4 * largest));
            out[1] = static_cast<std::uint8_t>(std::clamp(2 * (largest - 64), 0, 255));
            out[2] = 0;
        }
    }
    const double pixels = static_cast<double>(first.width) * static_cast<double>(first.height);
    found.comparison.mean = static_cast<double>(sum) / (3.0 * pixels);
    for (int y = 0; y + 8 <= first.height; y += 8) {
        for (int x = 0; x + 8 <= first.width; x += 8) {
            const double one = similarity(first, second, x, y);
            if (one < found.comparison.tiles.smallest) found.comparison.tiles = {one, x, y};
        }
    }
    return found;
}

}  // namespace fumon::plain
