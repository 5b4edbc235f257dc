#include "picture/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <mutex>

#include "base/error.h"
#include "base/worker_pool.h"
#include "picture/pixels/level_vectors.h"

namespace fumon {

namespace {

void check_sizes(const Image& first, const Image& second) {
    if (first.width != second.width || first.height != second.height) {
        throw InputError(fmt::format("pictures of {} × {} and {} × {} pixels cannot be compared",
                                     first.width, first.height, second.width, second.height));
    }
    if (first.width < 1 || first.height < 1)
        throw InputError("pictures without pixels cannot be compared");
}

/// Whether something can be seen through a picture: not where all of it is opaque.
bool has_transparency(const Image& image) {
    return std::any_of(image.alpha.begin(), image.alpha.end(),
                       [](std::uint8_t alpha) { return alpha != 255; });
}

/// The picture with another's levels in ignored pixels.
Image with_ignored_of(Image image, const Image& other, const IgnoredPixels& ignored) {
    for (std::size_t i = 0; i < image.rgb.size(); ++i) {
        if (ignored.flags[i / 3] != 0) image.rgb[i] = other.rgb[i];
    }
    return image;
}

/// A row of pixels laid on a grey, as composited_on() does it.
void composite_row(const std::uint8_t* levels, const std::uint8_t* alpha, std::size_t width,
                   std::uint8_t grey, std::uint8_t* out) {
    if (std::all_of(alpha, alpha + width, [](std::uint8_t share) { return share == 255; })) {
        std::memcpy(out, levels, 3 * width);
        return;
    }
    for (std::size_t x = 0; x < width; ++x, levels += 3, out += 3) {
        const unsigned share = alpha[x];
        const unsigned ground = (255U - share) * grey + 127U;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const unsigned both = share * levels[channel] + ground;
            // both / 255, for all up to 65534
            out[channel] = static_cast<std::uint8_t>((both + 1U + (both >> 8U)) >> 8U);
        }
    }
}

/// As composited_on(), by all threads, into a picture that may have been used so before.
const Image& composited_on(const Image& image, std::uint8_t grey, WorkerPool& pool, Image& whole) {
    if (!image.transparent()) return image;
    if (whole.width != image.width || whole.height != image.height)
        whole = Image(image.width, image.height);
    pool.for_ranges(image.height, [&](int begin, int end) {
        const auto width = static_cast<std::size_t>(image.width);
        for (int y = begin; y < end; ++y) {
            const std::uint8_t* alpha = image.alpha.data() + static_cast<std::size_t>(y) * width;
            composite_row(image.row(y), alpha, width, grey, whole.row(y));
        }
    });
    return whole;
}

/// Of small pictures the caller alone: threads would take longer to start.
int threads_for(const Image& image) {
    constexpr std::size_t large = std::size_t{3} << 18U;  // bytes, of a quarter of a megapixel
    return image.rgb.size() < large ? 1 : 0;
}

/// Adds what the pixels of two opaque pictures differ by.
void compare_rows(const Image& first, const Image& second, WorkerPool& pool,
                  Comparison& comparison) {
    std::int64_t sum = 0;
    std::mutex mutex;
    pool.for_ranges(first.height, [&](int begin, int end) {
        level_vectors::RowDifference mine;
        std::int64_t changed = 0;
        for (int y = begin; y < end; ++y) {
            const std::uint8_t* a = first.row(y);
            const std::uint8_t* b = second.row(y);
            if (std::memcmp(a, b, 3 * static_cast<std::size_t>(first.width)) == 0) continue;
            const auto row = level_vectors::row_difference(a, b, first.width);
            mine.largest = std::max(mine.largest, row.largest);
            changed += row.changed;
            mine.sum += row.sum;
        }
        const std::lock_guard lock(mutex);
        comparison.largest = std::max(comparison.largest, mine.largest);
        comparison.changed += changed;
        sum += mine.sum;
    });
    const double pixels = static_cast<double>(first.width) * static_cast<double>(first.height) -
                          static_cast<double>(comparison.ignored);
    comparison.changed_share = static_cast<double>(comparison.changed) / pixels;
    comparison.mean = static_cast<double>(sum) / (3.0 * pixels);
}

ThumbnailDifference compare_thumbnails(const Image& first, const Image& second, WorkerPool& pool) {
    std::array<Thumbnail, 2> thumbnails;
    pool.for_ranges(2, [&](int begin, int end) {
        for (int i = begin; i < end; ++i)
            thumbnails.at(static_cast<std::size_t>(i)) = thumbnail_of(i == 0 ? first : second);
    });
    return thumbnail_difference(thumbnails[0], thumbnails[1]);
}

/// Compares two opaque pictures, whose ignored pixels are the same.
Comparison compare_opaque(const Image& first, const Image& second, const IgnoredPixels& ignored,
                          WorkerPool& pool) {
    Comparison comparison;
    comparison.ignored = ignored.count();
    comparison.ignored_share = ignored.share();
    compare_rows(first, second, pool, comparison);
    if (comparison.changed == 0) return comparison;
    comparison.tiles = tile_similarity(first, second, ignored, pool);
    comparison.thumbnail = compare_thumbnails(first, second, pool);
    return comparison;
}

Comparison compare_any(const Image& first, const Image& second, const IgnoredPixels& ignored,
                       WorkerPool& pool) {
    if (!has_transparency(first) && !has_transparency(second))
        return compare_opaque(first, second, ignored, pool);
    Image whole_first;
    Image whole_second;
    const auto on = [&](std::uint8_t grey) {
        return compare_opaque(composited_on(first, grey, pool, whole_first),
                              composited_on(second, grey, pool, whole_second), ignored, pool);
    };
    const Comparison dark = on(0);
    const Comparison pale = on(255);
    return dark.mean > pale.mean ? dark : pale;
}

}  // namespace

Comparison compare(const Image& first, const Image& second, const IgnoredPixels& ignored) {
    check_sizes(first, second);
    WorkerPool pool(threads_for(first), "fumon-compare");
    if (ignored.any()) {
        return compare_any(blanked(first, ignored), blanked(second, ignored), ignored, pool);
    }
    return compare_any(first, second, ignored, pool);
}

std::string_view name_of(Likeness likeness) {
    constexpr std::array<std::string_view, 4> names{"different", "close", "same to the eye",
                                                    "identical"};
    return names[static_cast<std::size_t>(likeness)];
}

Likeness likeness(const Comparison& comparison) {
    const auto within = [&](const LikenessLimits& limits) {
        return comparison.thumbnail.largest <= limits.thumbnail &&
               comparison.tiles.smallest >= limits.tile_ssim;
    };
    if (comparison.changed == 0) return Likeness::identical;
    if (within(same_to_the_eye_limits)) return Likeness::same_to_the_eye;
    return within(close_limits) ? Likeness::close : Likeness::different;
}

std::string likeness_help() {
    return fmt::format(
        "identical        every pixel is the same\n"
        "same to the eye  thumbnails within {} grey levels and every 8 x 8 tile's SSIM at least "
        "{},\n"
        "                 as on another processor (0.001, 0.999), the sun 0.1 degrees on (0.5, "
        "0.992)\n"
        "close            within {} and at least {}, as one sample a pixel for four (0.2, 0.48),\n"
        "                 dunes a step later (1.7, 0.44)\n"
        "different        all else, as the sun 1 degree on (6.0, 0.87), another seed (53, -0.73)\n",
        same_to_the_eye_limits.thumbnail, same_to_the_eye_limits.tile_ssim, close_limits.thumbnail,
        close_limits.tile_ssim);
}

Image difference_picture(const Image& first, const Image& second, const IgnoredPixels& ignored) {
    check_sizes(first, second);
    WorkerPool pool(threads_for(first), "fumon-compare");
    if (has_transparency(first) || has_transparency(second)) {
        Image whole_first;
        Image whole_second;
        return difference_picture(composited_on(first, 255, pool, whole_first),
                                  composited_on(second, 255, pool, whole_second), ignored);
    }
    if (ignored.any()) {
        const Image same_there = with_ignored_of(second, first, ignored);
        return hatched(difference_picture(first, same_there), ignored);
    }
    Image picture(first.width, first.height);
    pool.for_ranges(first.height, [&](int begin, int end) {
        for (int y = begin; y < end; ++y)
            level_vectors::mark_row(first.row(y), second.row(y), first.width, picture.row(y));
    });
    return picture;
}

}  // namespace fumon
