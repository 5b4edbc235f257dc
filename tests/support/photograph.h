#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include "base/image.h"

/// Numbers by which pictures of sand are held beside photographs.
namespace fumon::photograph {

/// Linear light of a display value, 0 … 1 (sRGB, IEC 61966-2-1).
inline double linear(std::uint8_t value) {
    const double v = value / 255.0;
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

inline double luminance(const std::uint8_t* rgb) {
    return 0.2126 * linear(rgb[0]) + 0.7152 * linear(rgb[1]) + 0.0722 * linear(rgb[2]);
}

/// CIE 1976 L*.
inline double lightness(double y) {
    return y > 216.0 / 24389.0 ? 116.0 * std::cbrt(y) - 16.0 : y * 24389.0 / 27.0;
}

struct Hue {
    double degrees = 0.0;
    double saturation = 0.0;
};

inline Hue hue_of(const std::array<double, 3>& c) {
    const double most = *std::ranges::max_element(c);
    const double least = *std::ranges::min_element(c);
    const double span = most - least;
    if (span <= 0.0) return {};
    double sixth = 0.0;
    if (most == c[0]) {
        sixth = (c[1] - c[2]) / span;
    } else if (most == c[1]) {
        sixth = 2.0 + (c[2] - c[0]) / span;
    } else {
        sixth = 4.0 + (c[0] - c[1]) / span;
    }
    return {60.0 * (sixth < 0.0 ? sixth + 6.0 : sixth), span / most};
}

struct LightAndShadow {
    Hue shadow;  ///< of the mean of the darkest 15 %
    Hue light;   ///< of the mean of the brightest 25 %
};

/// Of the lowest `share` of a picture, by display values.
inline LightAndShadow light_and_shadow(const Image& image, double share = 0.6) {
    struct Pixel {
        double light;
        const std::uint8_t* rgb;
    };
    std::vector<Pixel> pixels;
    for (int y = static_cast<int>((1.0 - share) * image.height); y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const std::uint8_t* rgb = image.row(y) + 3 * static_cast<std::size_t>(x);
            pixels.push_back({luminance(rgb), rgb});
        }
    }
    std::ranges::stable_sort(pixels, {}, &Pixel::light);
    const auto mean = [&](double from, double to) {
        std::array<double, 3> sum{};
        const auto count = static_cast<double>(pixels.size());
        const auto first = static_cast<std::size_t>(from * count);
        const auto last = static_cast<std::size_t>(to * count);
        for (std::size_t i = first; i < last; ++i) {
            for (std::size_t band = 0; band < 3; ++band) sum[band] += pixels[i].rgb[band];
        }
        return hue_of(sum);
    };
    return {mean(0.0, 0.15), mean(0.75, 1.0)};
}

/// From the 5th to the 95th percentile of L*.
inline double lightness_span(const Image& image) {
    std::vector<double> values;
    for (std::size_t i = 0; i < image.rgb.size(); i += 3)
        values.push_back(lightness(luminance(image.rgb.data() + i)));
    std::ranges::sort(values);
    const auto at = [&](double share) {
        return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
    };
    return at(0.95) - at(0.05);
}

/// The share of pixels of which a channel is 0 or 255.
inline double share_at_ends(const Image& image) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
        const auto [least, most] = std::minmax({image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]});
        if (least == 0 || most == 255) ++count;
    }
    return 3.0 * static_cast<double>(count) / static_cast<double>(image.rgb.size());
}

/// Mean luminance of each row.
inline std::vector<double> rows_of_luminance(const Image& image) {
    std::vector<double> rows;
    for (int y = 0; y < image.height; ++y) {
        double sum = 0.0;
        for (int x = 0; x < image.width; ++x)
            sum += luminance(image.row(y) + 3 * static_cast<std::size_t>(x));
        rows.push_back(sum / image.width);
    }
    return rows;
}

/// The exponent of the radial power of the linear luminance of a square at the middle of the lower
/// edge, `side` pixels wide (even), under a Hann window, fitted log on log from 8/side to .35
/// cycles a pixel.
inline double spectral_slope(const Image& image, int side) {
    const auto n = static_cast<std::size_t>(side);
    const double turn = 2.0 * std::numbers::pi / side;
    std::vector<double> values(n * n);
    double mean = 0.0;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const std::uint8_t* rgb = image.row(image.height - side + y) +
                                      3 * static_cast<std::size_t>((image.width - side) / 2 + x);
            values[static_cast<std::size_t>(y) * n + static_cast<std::size_t>(x)] = luminance(rgb);
            mean += luminance(rgb) / (static_cast<double>(side) * side);
        }
    }
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            double& value = values[static_cast<std::size_t>(y) * n + static_cast<std::size_t>(x)];
            value = (value - mean) * (0.5 - 0.5 * std::cos(turn * x)) *
                    (0.5 - 0.5 * std::cos(turn * y));
        }
    }
    // Discrete transform over rows, then over columns, for the wave numbers that the fit takes.
    const int most = static_cast<int>(0.35 * side);
    std::vector<double> cosine(n);
    std::vector<double> sine(n);
    for (std::size_t i = 0; i < n; ++i) {
        cosine[i] = std::cos(turn * static_cast<double>(i));
        sine[i] = std::sin(turn * static_cast<double>(i));
    }
    const auto columns = static_cast<std::size_t>(most) + 1;
    std::vector<double> real(columns * n);
    std::vector<double> imaginary(columns * n);
    for (std::size_t k = 0; k < columns; ++k) {
        for (std::size_t y = 0; y < n; ++y) {
            double re = 0.0;
            double im = 0.0;
            for (std::size_t x = 0; x < n; ++x) {
                re += values[y * n + x] * cosine[k * x % n];
                im -= values[y * n + x] * sine[k * x % n];
            }
            real[k * n + y] = re;
            imaginary[k * n + y] = im;
        }
    }
    std::vector<double> power(columns, 0.0);
    std::vector<double> count(columns, 0.0);
    for (std::size_t k = 0; k < columns; ++k) {
        for (int l = -most; l <= most; ++l) {
            const double radius = std::sqrt(static_cast<double>(k * k) + 1.0 * l * l);
            const auto ring = static_cast<std::size_t>(radius + 0.5);
            if (ring < 8 || ring >= columns) continue;
            const auto step = static_cast<std::size_t>((l + side) % side);
            double re = 0.0;
            double im = 0.0;
            for (std::size_t y = 0; y < n; ++y) {
                const double c = cosine[step * y % n];
                const double s = sine[step * y % n];
                re += real[k * n + y] * c + imaginary[k * n + y] * s;
                im += imaginary[k * n + y] * c - real[k * n + y] * s;
            }
            power[ring] += re * re + im * im;
            count[ring] += 1.0;
        }
    }
    double sum = 0.0;
    double sum_x = 0.0;
    double sum_y = 0.0;
    double sum_xx = 0.0;
    double sum_xy = 0.0;
    for (std::size_t ring = 8; ring < columns; ++ring) {
        if (count[ring] == 0.0 || power[ring] <= 0.0) continue;
        const double x = std::log(static_cast<double>(ring));
        const double y = std::log(power[ring] / count[ring]);
        sum += 1.0;
        sum_x += x;
        sum_y += y;
        sum_xx += x * x;
        sum_xy += x * y;
    }
    return (sum * sum_xy - sum_x * sum_y) / (sum * sum_xx - sum_x * sum_x);
}

}  // namespace fumon::photograph
