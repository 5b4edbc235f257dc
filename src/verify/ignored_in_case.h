#pragma once

#include <string_view>
#include <vector>

#include "base/image.h"
#include "base/snapshot.h"
#include "picture/baseline.h"
#include "picture/pixels/ignored_pixels.h"
#include "scene/scene.h"

namespace fumon {

/// Where an overlay stands on a picture.
struct OverlayRectangle {
    std::string_view kind;  ///< as scenes call it
    PixelBox box;           ///< with its plate
};

/// Where the overlays stand that a scene shows on its pictures, but for those over all of it;
/// `first` is the run's first snapshot as the model gives it. Throws as FrameOverlays.
std::vector<OverlayRectangle> overlay_rectangles(const Scene& scene, const Snapshot& first);

/// What a case ignores of its picture, on which these overlays stand. Throws InputError located at
/// the case, as ignored_pixels(), and where its scene shows no overlay of a kind that it names. Of
/// a mask that a baseline names which is not trusted, messages do not tell whether it is there.
IgnoredPixels ignored_in_case(const Baseline& baseline, const BaselineCase& one, bool trusted,
                              const Image& picture, const std::vector<OverlayRectangle>& places);

}  // namespace fumon
