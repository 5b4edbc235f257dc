#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <string>
#include <vector>

#include "base/image.h"
#include "keys/assign.h"
#include "picture/pixels/ignored_pixels.h"

namespace fumon {

/// What a comparison is asked to leave out.
struct IgnoreRules {
    std::vector<PixelBox> boxes;
    std::vector<std::string> overlays;  ///< kinds of a scene's overlays: "time", "colour-bar"
    std::string mask;                   ///< a PNG file whose white pixels are ignored; empty: none

    [[nodiscard]] bool any() const { return !boxes.empty() || !overlays.empty() || !mask.empty(); }
};

/// The box of a text "X,Y,WIDTH,HEIGHT". Throws InputError "what is wrong; what would be right".
PixelBox read_box(const std::string& text);

/// Adds the items of `ignore = [[x, y, width, height], "time", …]`. Throws InputError, located at
/// the item.
void read_ignore(const toml::node& value, const std::string& path, const Locate& locate,
                 IgnoreRules& rules);

/// The pixels that they ignore of a picture, with boxes in which its overlays stand; the mask lies
/// in `folder`. Throws InputError "what is wrong; what would be right" for a box outside of the
/// picture, a mask that cannot be read or has a different size, and where more than
/// `largest_ignored_share` of the picture would be left out.
IgnoredPixels ignored_pixels(const IgnoreRules& rules, const Image& picture,
                             const std::filesystem::path& folder,
                             const std::vector<PixelBox>& of_overlays = {});

/// Throws InputError where more than `largest_ignored_share` of a picture is ignored.
void check_share(const IgnoredPixels& ignored);

}  // namespace fumon
