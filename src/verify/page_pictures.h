#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "base/image.h"
#include "picture/baseline_records.h"
#include "picture/pixels/ignored_pixels.h"

namespace fumon {

/// A picture of a case that does not pass.
struct PagePicture {
    std::string kind;      ///< SUITE/NAME-KIND.png is its file
    std::string shown_as;  ///< the class of its place on the page
    std::string caption;
    std::string png;  ///< its bytes
    /// Of the picture as the page shows it, with ignored pixels hatched; empty: as it is.
    std::string hatched{};
};

/// How the files of a case's pictures are called.
inline constexpr std::string_view expected_kind = "expected";
inline constexpr std::string_view got_kind = "got";
inline constexpr std::string_view thumbnail_kind = "got-thumbnail";
inline constexpr std::string_view difference_kind = "difference";
inline constexpr std::array<std::string_view, 4> picture_kinds{expected_kind, got_kind,
                                                               thumbnail_kind, difference_kind};

/// A picture as fumon's own PNG.
std::string as_png(const Image& image);

/// What was got and, where `record` is not null, what was expected and where they differ: of the
/// kept picture, else of the thumbnails. On the page and in the difference, ignored pixels are
/// hatched.
std::vector<PagePicture> page_pictures(const Image& got, const BaselineRecord* record,
                                       const Image* expected, const IgnoredPixels& ignored = {});

}  // namespace fumon
