#include "verify/page_pictures.h"

#include <cmath>

#include "picture/compare.h"
#include "picture/png.h"

namespace fumon {

namespace {

/// A thumbnail as a picture of its own size.
Image picture_of(const Thumbnail& thumbnail) {
    Image image(Thumbnail::width, Thumbnail::height);
    for (std::size_t i = 0; i < Thumbnail::count; ++i)
        image.rgb[i] = static_cast<std::uint8_t>(std::lround(thumbnail.levels[i]));
    return image;
}

bool same_size(const Image& first, const Image& second) {
    return first.width == second.width && first.height == second.height;
}

}  // namespace

std::string as_png(const Image& image) {
    const auto bytes = encode_png(image, screen_dots_per_inch, own_text());
    return {bytes.begin(), bytes.end()};
}

std::vector<PagePicture> page_pictures(const Image& got, const BaselineRecord* record,
                                       const Image* expected, const IgnoredPixels& ignored) {
    std::vector<PagePicture> pictures;
    const auto show = [&](const Image& image, std::string_view kind, std::string_view shown_as,
                          const std::string& caption) {
        const bool hatches = ignored.any() && kind != difference_kind &&
                             ignored.width == image.width && ignored.height == image.height;
        pictures.push_back({std::string(kind), std::string(shown_as), caption, as_png(image),
                            hatches ? as_png(hatched(image, ignored)) : std::string()});
    };
    if (record == nullptr) {
        show(got, got_kind, "got", "got");
        return pictures;
    }
    const bool whole = expected != nullptr && same_size(*expected, got);
    const Image before = whole ? *expected : picture_of(record->fingerprint.thumbnail);
    const Image after = whole ? got : picture_of(thumbnail_of(blanked(got, ignored)));
    const std::string of_what = whole ? "" : " (thumbnail)";
    show(before, expected_kind, "expected", "expected" + of_what);
    show(after, whole ? got_kind : thumbnail_kind, "got", "got" + of_what);
    show(difference_picture(before, after, whole ? ignored : IgnoredPixels{}), difference_kind,
         "difference", "difference" + of_what);
    if (!whole) show(got, got_kind, "whole", "got, whole");
    return pictures;
}

}  // namespace fumon
