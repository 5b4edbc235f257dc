#include "figure/canvas/layers.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace fumon {

namespace {

constexpr double shadow_strength_ratio = 2.2;  // the edges of letters are to stand on full shadow
constexpr double most_shadow_opacity = 0.72;

/// Means over 2·radius + 1 numbers, `count` of them `stride` apart; 0 beyond both ends.
void blur_line(float* line, int count, std::ptrdiff_t stride, int radius,
               std::vector<float>& copy) {
    copy.resize(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) copy[static_cast<std::size_t>(i)] = line[i * stride];
    const auto value = [&](int i) {
        return i < 0 || i >= count ? 0.0F : copy[static_cast<std::size_t>(i)];
    };
    double sum = 0.0;
    for (int i = 0; i < radius; ++i) sum += value(i);
    for (int i = 0; i < count; ++i) {
        sum += value(i + radius);
        line[i * stride] = static_cast<float>(sum / (2 * radius + 1));
        sum -= value(i - radius);
    }
}

}  // namespace

void composite_over(Image& image, const CanvasLayer& layer, int left, int top, double opacity) {
    const auto share =
        static_cast<std::uint32_t>(std::lround(255.0 * std::clamp(opacity, 0.0, 1.0)));
    if (share == 0) return;
    const int begin = std::max(0, -left);
    const int end = std::min(layer.width, image.width - left);
    for (int y = std::max(0, -top); y < std::min(layer.height, image.height - top); ++y) {
        std::size_t n = static_cast<std::size_t>(y) * static_cast<std::size_t>(layer.width) +
                        static_cast<std::size_t>(begin);
        std::uint8_t* out = image.row(top + y) + 3 * static_cast<std::ptrdiff_t>(left + begin);
        std::uint8_t* alpha =
            image.transparent() ? image.alpha.data() + (out - image.rgb.data()) / 3 : nullptr;
        for (int x = begin; x < end; ++x, ++n) {
            const std::uint32_t pixel = layer.pixels[n];
            const auto part = [&](unsigned shift) {
                const std::uint32_t whole = (pixel >> shift) & 255U;
                return share == 255U ? whole : (whole * share + 127U) / 255U;
            };
            const std::uint32_t through = 255U - part(24U);
            if (alpha != nullptr) {  // out: the mean of both colours by how much of each is seen
                const std::uint32_t below = *alpha * through;
                const std::uint32_t both = 255U * part(24U) + below;
                for (const unsigned shift : {16U, 8U, 0U}) {
                    const std::uint32_t sum = 255U * 255U * part(shift) + *out * below;
                    if (both > 0U)
                        *out = static_cast<std::uint8_t>(std::min(255U, (sum + both / 2U) / both));
                    ++out;
                }
                *alpha++ = static_cast<std::uint8_t>((both + 127U) / 255U);
                continue;
            }
            for (const unsigned shift : {16U, 8U, 0U}) {
                const std::uint32_t below = (*out * through + 127U) / 255U;
                *out++ = static_cast<std::uint8_t>(std::min(255U, part(shift) + below));
            }
        }
    }
}

CanvasLayer with_soft_shadow(const CanvasLayer& layer, int radius) {
    std::vector<float> shadow(layer.pixels.size());
    for (std::size_t i = 0; i < shadow.size(); ++i)
        shadow[i] = static_cast<float>(layer.pixels[i] >> 24U);
    std::vector<float> copy;
    const int step = std::max(1, radius / 3);
    const auto width = static_cast<std::ptrdiff_t>(layer.width);
    for (int pass = 0; pass < 3; ++pass) {  // three boxes: nearly a Gaussian
        for (int y = 0; y < layer.height; ++y)
            blur_line(shadow.data() + y * width, layer.width, 1, step, copy);
        for (int x = 0; x < layer.width; ++x)
            blur_line(shadow.data() + x, layer.height, width, step, copy);
    }
    CanvasLayer whole = layer;
    for (std::size_t i = 0; i < shadow.size(); ++i) {
        const double dark = std::min(
            most_shadow_opacity, shadow_strength_ratio * static_cast<double>(shadow[i]) / 255.0);
        const std::uint32_t opacity = layer.pixels[i] >> 24U;
        const double below = dark * (255.0 - opacity);
        const auto alpha = static_cast<std::uint32_t>(std::lround(opacity + below));
        whole.pixels[i] = std::min(alpha, 255U) << 24U | (layer.pixels[i] & 0x00FFFFFFU);
    }
    return whole;
}

CanvasLayer inverted(CanvasLayer layer) {
    for (std::uint32_t& pixel : layer.pixels) {
        const std::uint32_t alpha = pixel >> 24U;
        std::uint32_t turned = alpha;
        for (const unsigned shift : {16U, 8U, 0U})
            turned = turned << 8U | (alpha - std::min(alpha, (pixel >> shift) & 255U));
        pixel = turned;
    }
    return layer;
}

}  // namespace fumon
