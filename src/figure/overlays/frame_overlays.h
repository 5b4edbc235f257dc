#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "figure/overlays/frame_contours.h"
#include "figure/overlays/frame_layers.h"
#include "figure/overlays/overlay.h"
#include "figure/words/words.h"

namespace fumon {

/// How overlays stand on frames.
struct OverlayStyle {
    bool shadowed = false;      ///< pale letters with a soft shadow instead of dark ones on a plate
    bool camera_moves = false;  ///< frames have a camera each (OverlayFrame::camera)
    double edge = 0.0;          ///< pixels kept free along the picture's edges, at least
    /// The time up to which frames go, where that is known.
    std::optional<double> end_time{};
    double under = 0.0;  ///< pixels along the upper edge that something else stands on
    TimeNote time_note = TimeNote::none;
};

/// Where an overlay stands.
struct PlacedOverlay {
    std::size_t number = 0;  ///< of the scene's overlays, shown ones and others
    CanvasBox box;           ///< with its plate, whole pixels
    double font_size = 0.0;
};

/// All overlays on the frames of a run, and the contours of their ground, drawn by the same code as
/// scale bars, arrows and colour bars in figures.
///
/// Overlays of one corner stand below one another, in the scene's order; their places are the same
/// in all frames. Nothing overlaps or leaves the picture: where there is too little room, texts
/// without a size of their own become smaller, down to 6 pixels. Each overlay is drawn on a pale
/// plate into a layer of its own, which is reused while its content stays the same. Layers are
/// blended over the frame in sRGB, in which Cairo also blends text and plate, so that an opacity
/// looks as it does in figures and in other programs. Pixels depend on the system's fonts and on
/// the version of Pango where a text has letters that fumon does not ship.
class FrameOverlays {
  public:
    /// The overlays of a scene that are shown; the scene outlives them, and `first` is the run's
    /// first snapshot as the model gives it. Throws KeyError for one that the scene cannot have, or
    /// for which the picture is too small.
    FrameOverlays(const Scene& scene, const Snapshot& first, const OverlayStyle& style = {});
    ~FrameOverlays();
    FrameOverlays(const FrameOverlays&) = delete;
    FrameOverlays& operator=(const FrameOverlays&) = delete;

    [[nodiscard]] const std::vector<PlacedOverlay>& placed() const { return placed_; }
    /// Whether one of their texts is set in the system's fonts.
    [[nodiscard]] bool uses_system_fonts() const { return system_fonts_; }
    /// Lays them over a frame. `opacity`: 0 … 1, of all of them.
    void draw(Image& image, const OverlayFrame& frame, double opacity = 1.0);

  private:
    struct DrawnOverlay;

    std::shared_ptr<const WordTable> words_;   ///< in which they are written
    std::unique_ptr<FrameContours> contours_;  ///< below all others; null: none
    std::unique_ptr<FrameLayers> layers_;      ///< above these, below the others; null: none
    std::vector<PlacedOverlay> placed_;
    std::vector<DrawnOverlay> drawn_;
    bool system_fonts_ = false;
    std::vector<PlacedOverlay> over_all_placed_;  ///< those that fill the picture, below the others
    std::vector<DrawnOverlay> over_all_;
};

}  // namespace fumon
