#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/snapshot.h"
#include "figure/canvas/canvas.h"
#include "figure/canvas/furniture.h"
#include "measure/measured_rows.h"
#include "render/colour/colouring.h"
#include "render/view/camera.h"
#include "scene/figure/overlay_kinds.h"
#include "scene/scene.h"

namespace fumon {

/// What a time plate says beside the time: that each frame shows the nearest record of a run as it
/// is, or what changes evenly between two records.
enum class TimeNote { none, held, blended };

/// What overlays are made for: the frames of a scene, which outlives them.
struct OverlayScene {
    const Scene& scene;
    const Snapshot& first;      ///< of the run, as the model gives it
    const Snapshot& shown;      ///< the same as it is drawn, see shown_snapshot()
    bool flat = false;          ///< the frames are a section's flat figure
    bool camera_moves = false;  ///< as frames say, see OverlayFrame
    /// The time up to which frames go, where that is known.
    std::optional<double> end_time{};
    TimeNote time_note = TimeNote::none;
};

/// One frame, for what stands over it.
struct OverlayFrame {
    const Snapshot& snapshot;  ///< as the model gives it
    const MeasuredRows& rows;  ///< up to it
    FrameColourRange colours{};
    /// Its camera, where it is not the one of the scene's view.
    const Camera* camera = nullptr;
    /// The height in pixels of that camera's picture, where it is not the scene's: films of several
    /// runs show it in a part of theirs.
    std::int64_t camera_height = 0;
};

/// Something written or drawn over every frame of a run.
class Overlay {
  public:
    Overlay() = default;
    Overlay(const Overlay&) = delete;
    Overlay& operator=(const Overlay&) = delete;
    virtual ~Overlay() = default;

    /// Whether it is drawn over the whole picture, below the plates of the others; `box` is then
    /// the picture.
    [[nodiscard]] virtual bool fills_picture() const { return false; }
    /// Of one that fills the picture: boxes that its texts keep away from, and the opacity of the
    /// pale ground behind each of them.
    virtual void avoid_boxes(const std::vector<CanvasBox>& taken, double plate) {
        (void)taken;
        (void)plate;
    }
    /// What it takes at the canvas's font size: the same for all frames, so that nothing moves.
    [[nodiscard]] virtual FurnitureSize size(const Canvas& canvas) const = 0;
    /// The same text for frames over which it looks the same.
    [[nodiscard]] virtual std::string appearance_in(const OverlayFrame& frame) const = 0;
    /// Draws it into `box`, which has its size.
    virtual void draw(Canvas& canvas, const CanvasBox& box, const OverlayFrame& frame) const = 0;
};

/// One for each line of FUMON_OVERLAY_KINDS (scene/figure/overlay_kinds.h): makes the scene's
/// overlay of that number. Throws KeyError where the scene cannot have it.
#define FUMON_MAKER(name, word, shows, help) \
    std::unique_ptr<Overlay> make_##name##_overlay(const OverlayScene& on, std::size_t number);
FUMON_OVERLAY_KINDS(FUMON_MAKER)
#undef FUMON_MAKER

}  // namespace fumon
