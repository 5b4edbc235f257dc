#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/samples/resolve_vectors.cpp"
#include <hwy/foreach_target.h>
// Those below are included once for each target.
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>

#include "render/samples/resolve_vectors.h"

HWY_BEFORE_NAMESPACE();
namespace fumon::samples {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Whole = hn::ScalableTag<std::uint32_t>;

HWY_INLINE void accumulate(hn::Vec<Whole> amount, std::uint32_t* sum) {
    const Whole d;
    hn::StoreU(hn::LoadU(d, sum) + amount, d, sum);
}

void add_squares(const std::uint32_t* samples, int count, const Sums& sums) {
    const Whole d;
    const auto low = hn::Set(d, 255U);
    for (std::size_t x = 0; x < static_cast<std::size_t>(count); x += hn::Lanes(d)) {
        const auto sample = hn::LoadU(d, samples + x);
        const auto red = hn::And(sample, low);
        const auto green = hn::And(hn::ShiftRight<8>(sample), low);
        const auto blue = hn::And(hn::ShiftRight<16>(sample), low);
        accumulate(red * red, sums.red + x);
        accumulate(green * green, sums.green + x);
        accumulate(blue * blue, sums.blue + x);
        accumulate(hn::ShiftRight<31>(sample), sums.covered + x);
    }
}

/// sum[x] = sum[2x] + sum[2x + 1] for 0 ≤ x < count.
void halve(std::uint32_t* sum, int count) {
    const Whole d;
    for (std::size_t x = 0; x < static_cast<std::size_t>(count); x += hn::Lanes(d)) {
        hn::Vec<Whole> even;
        hn::Vec<Whole> odd;
        hn::LoadInterleaved2(d, sum + 2 * x, even, odd);
        hn::StoreU(even + odd, d, sum + x);
    }
}

/// The roots of means over factor² samples, of which those that nothing covers are `behind`.
void take_roots(const std::uint32_t* sum, const std::uint32_t* covered, const std::uint8_t* behind,
                int factor, int count, std::uint8_t* pixels) {
    const Whole d;
    const hn::Rebind<std::uint8_t, Whole> bytes;
    const hn::Rebind<std::int32_t, Whole> integers;
    const hn::Rebind<float, Whole> floats;
    const auto all = hn::Set(d, static_cast<std::uint32_t>(factor * factor));
    const auto share = hn::Set(floats, 1.0F / static_cast<float>(factor));
    const auto half = hn::Set(floats, 0.5F);
    for (std::size_t x = 0; x < static_cast<std::size_t>(count); x += hn::Lanes(d)) {
        const auto background = hn::PromoteTo(d, hn::LoadU(bytes, behind + x));
        const auto open = all - hn::LoadU(d, covered + x);
        const auto squares = hn::LoadU(d, sum + x) + background * background * open;
        const auto root = hn::Sqrt(hn::ConvertTo(floats, hn::BitCast(integers, squares)));
        const auto nearest = hn::ConvertTo(integers, root * share + half);
        hn::StoreU(hn::DemoteTo(bytes, nearest), bytes, pixels + x);
    }
}

void interleave(const std::uint8_t* red, const std::uint8_t* green, const std::uint8_t* blue,
                int count, std::uint8_t* rgb) {
    const hn::ScalableTag<std::uint8_t> d;
    const auto pixels = static_cast<std::size_t>(count);
    std::size_t x = 0;
    for (; x + hn::Lanes(d) <= pixels; x += hn::Lanes(d)) {
        hn::StoreInterleaved3(hn::LoadU(d, red + x), hn::LoadU(d, green + x),
                              hn::LoadU(d, blue + x), d, rgb + 3 * x);
    }
    for (; x < pixels; ++x) {
        rgb[3 * x] = red[x];
        rgb[3 * x + 1] = green[x];
        rgb[3 * x + 2] = blue[x];
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace fumon::samples
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumon {

namespace samples {

HWY_EXPORT(add_squares);
HWY_EXPORT(halve);
HWY_EXPORT(take_roots);
HWY_EXPORT(interleave);

}  // namespace samples

namespace {

/// Longer than a row by the widest vector of any target (64 bytes).
std::size_t padded(int count) {
    return static_cast<std::size_t>(count) + 64;
}

}  // namespace

ColourPlanes::ColourPlanes(int width)
    : red(padded(width)), green(padded(width)), blue(padded(width)) {}

RowResolver::RowResolver(int width, int factor)
    : width_(width),
      factor_(factor),
      red_(padded(width * factor)),
      green_(padded(width * factor)),
      blue_(padded(width * factor)),
      covered_(padded(width * factor)),
      pixels_(width) {}

void RowResolver::add(const std::uint32_t* row) {
    using namespace samples;
    HWY_DYNAMIC_DISPATCH(add_squares)
    (row, width_ * factor_, {red_.data(), green_.data(), blue_.data(), covered_.data()});
}

void RowResolver::sum_up() {
    using namespace samples;
    for (std::vector<std::uint32_t>* sum : {&red_, &green_, &blue_, &covered_}) {
        for (int count = width_ * factor_ / 2; count >= width_; count /= 2)
            HWY_DYNAMIC_DISPATCH(halve)(sum->data(), count);
    }
}

void RowResolver::reset() {
    for (std::vector<std::uint32_t>* sum : {&red_, &green_, &blue_, &covered_})
        std::fill(sum->begin(), sum->end(), 0U);
}

void RowResolver::finish_transparent(std::uint8_t* rgb, std::uint8_t* alpha) {
    sum_up();
    const auto all = static_cast<std::uint32_t>(factor_ * factor_);
    for (std::size_t x = 0; x < static_cast<std::size_t>(width_); ++x) {
        const std::uint32_t covered = covered_[x];
        alpha[x] = static_cast<std::uint8_t>((255U * covered + all / 2U) / all);
        for (const std::vector<std::uint32_t>* sum : {&red_, &green_, &blue_}) {
            const double mean = static_cast<double>((*sum)[x]) / std::max(covered, 1U);
            *rgb++ = static_cast<std::uint8_t>(std::sqrt(mean) + 0.5);
        }
    }
    reset();
}

void RowResolver::finish(const ColourPlanes& behind, std::uint8_t* rgb) {
    using namespace samples;
    sum_up();
    const auto take = [&](const std::vector<std::uint32_t>& sum,
                          const std::vector<std::uint8_t>& back,
                          std::vector<std::uint8_t>& pixels) {
        HWY_DYNAMIC_DISPATCH(take_roots)
        (sum.data(), covered_.data(), back.data(), factor_, width_, pixels.data());
    };
    take(red_, behind.red, pixels_.red);
    take(green_, behind.green, pixels_.green);
    take(blue_, behind.blue, pixels_.blue);
    HWY_DYNAMIC_DISPATCH(interleave)
    (pixels_.red.data(), pixels_.green.data(), pixels_.blue.data(), width_, rgb);
    reset();
}

void write_row(const ColourPlanes& planes, int width, std::uint8_t* rgb) {
    using namespace samples;
    HWY_DYNAMIC_DISPATCH(interleave)
    (planes.red.data(), planes.green.data(), planes.blue.data(), width, rgb);
}

void dilate_colours(Image& image) {
    const auto width = static_cast<std::size_t>(image.width);
    std::vector<int> filled;  // rows with a covered pixel
    for (int y = 0; y < image.height; ++y) {
        const std::uint8_t* alpha = image.alpha.data() + static_cast<std::size_t>(y) * width;
        std::uint8_t* row = image.row(y);
        std::vector<std::size_t> covered;
        for (std::size_t x = 0; x < width; ++x)
            if (alpha[x] != 0) covered.push_back(x);
        if (covered.empty()) continue;
        filled.push_back(y);
        auto next = covered.begin();
        for (std::size_t x = 0; x < width; ++x) {
            while (next + 1 != covered.end() && *next < x) ++next;
            std::size_t from = *next;
            if (from > x && next != covered.begin() && x - *(next - 1) <= from - x)
                from = *(next - 1);
            if (from != x) std::copy_n(row + 3 * from, 3, row + 3 * x);
        }
    }
    for (int y = 0; y < image.height && !filled.empty(); ++y) {
        const auto after = std::ranges::lower_bound(filled, y);
        if (after != filled.end() && *after == y) continue;
        int from = after == filled.end() ? filled.back() : *after;
        if (after != filled.begin() && y - *(after - 1) <= std::abs(from - y)) from = *(after - 1);
        std::copy_n(image.row(from), 3 * width, image.row(y));
    }
}

}  // namespace fumon
#endif
