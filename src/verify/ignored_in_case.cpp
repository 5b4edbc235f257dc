#include "verify/ignored_in_case.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>

#include "base/error.h"
#include "figure/overlays/frame_overlays.h"
#include "picture/png.h"
#include "scene/figure/overlay_kinds.h"

namespace fumon {

namespace {

/// Of a mask whose file may be anyone's. Throws InputError that tells nothing more of it.
void check_mask(const std::filesystem::path& folder, const std::string& mask,
                const Image& picture) {
    bool good = false;
    try {
        const Image read = read_png(folder / mask);
        good = read.width == picture.width && read.height == picture.height;
    } catch (const InputError&) {
        good = false;
    }
    if (good) return;
    throw InputError(fmt::format(
        "ignore_mask: {} is not a PNG of {} x {} pixels like the picture; --trust gives details",
        mask, picture.width, picture.height));
}

std::vector<PixelBox> boxes_of(const BaselineCase& one,
                               const std::vector<OverlayRectangle>& places) {
    std::vector<PixelBox> boxes;
    for (const std::string& kind : one.ignore.overlays) {
        const std::size_t before = boxes.size();
        for (const OverlayRectangle& place : places) {
            if (place.kind == kind) boxes.push_back(place.box);
        }
        if (boxes.size() == before) {
            throw InputError(fmt::format(
                "ignore: its picture has no overlay \"{}\"; leave it out, or name a box", kind));
        }
    }
    return boxes;
}

}  // namespace

std::vector<OverlayRectangle> overlay_rectangles(const Scene& scene, const Snapshot& first) {
    std::vector<OverlayRectangle> places;
    const FrameOverlays overlays(scene, first);
    for (const PlacedOverlay& placed : overlays.placed()) {
        const OverlayKind kind = scene.view.overlays[placed.number].kind;
        const CanvasBox& box = placed.box;
        places.push_back({overlay_kinds.at(static_cast<std::size_t>(kind)).choice.word,
                          {std::llround(box.x), std::llround(box.y), std::llround(box.width),
                           std::llround(box.height)}});
    }
    return places;
}

IgnoredPixels ignored_in_case(const Baseline& baseline, const BaselineCase& one, bool trusted,
                              const Image& picture, const std::vector<OverlayRectangle>& places) {
    try {
        const std::filesystem::path folder = baseline.file.parent_path();
        if (!trusted && !one.ignore.mask.empty()) check_mask(folder, one.ignore.mask, picture);
        return ignored_pixels(one.ignore, picture, folder, boxes_of(one, places));
    } catch (const InputError& fault) {
        throw placed(fmt::format("{}: cases.{}: ", one.place, one.name), fault);
    }
}

}  // namespace fumon
