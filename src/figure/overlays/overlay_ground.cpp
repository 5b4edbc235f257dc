#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "base/error.h"
#include "figure/overlays/overlay.h"
#include "figure/overlays/overlay_text.h"
#include "figure/panels/ground_arrow.h"
#include "figure/panels/scale_bar.h"
#include "figure/words/words.h"
#include "measure/suite.h"
#include "render/view/framing.h"
#include "scene/initial_bed.h"

namespace fumon {

namespace {

constexpr double longest_bar_share_of_picture = 0.2;  // of the picture's width

class ScaleBarOverlay : public Overlay {
  public:
    explicit ScaleBarOverlay(const OverlayScene& on)
        : view_(on.scene.view),
          block_(framed_block(view_, on.shown)),
          in_metres_(on.shown.scale.in_metres),
          moves_(on.camera_moves),
          camera_(camera_at_step(view_, block_, 0, on.scene.run.steps)) {}

    [[nodiscard]] FurnitureSize size(const Canvas& canvas) const override {
        if (!moves_) return scale_bar_size(canvas, bar(camera_, view_));
        ScaleBar widest{0.0, longest(), in_metres_ ? "500 mm" : "5000 " + unit_word("sites")};
        if (camera_.perspective) widest.text += word(" at the middle");
        return scale_bar_size(canvas, widest);
    }
    [[nodiscard]] std::string appearance_in(const OverlayFrame& frame) const override {
        const ScaleBar shown = bar_in(frame);
        return moves_ ? fmt::format("{} {}", shown.text, shown.drawn) : "";
    }
    void draw(Canvas& canvas, const CanvasBox& box, const OverlayFrame& frame) const override {
        draw_scale_bar(canvas, bar_in(frame), box);
    }

  private:
    [[nodiscard]] double longest() const {
        return longest_bar_share_of_picture * static_cast<double>(view_.image.width);
    }
    [[nodiscard]] ScaleBar bar(const Camera& camera, const View& view) const {
        ScaleBar made =
            round_scale_bar(in_metres_, pixels_per_length(camera, view) / block_.side, longest());
        if (camera.perspective) made.text += word(" at the middle");
        return made;
    }
    [[nodiscard]] ScaleBar bar_in(const OverlayFrame& frame) const {
        if (frame.camera == nullptr) return bar(camera_, view_);
        View of_camera = view_;
        if (frame.camera_height > 0) of_camera.image.height = frame.camera_height;
        return bar(*frame.camera, of_camera);
    }

    View view_;
    Block block_;
    bool in_metres_;
    bool moves_;
    Camera camera_;  ///< where frames name none
};

std::optional<GroundDirection> direction_of(const OverlayScene& on) {
    switch (on.first.landform) {
        case Landform::air:
        case Landform::bed:
        case Landform::profile:
            return wind_direction(on.first);
        case Landform::water:
            if (bed_kind(on.scene) == BedKind::file) return std::nullopt;
            return flow_direction();
        case Landform::pile:
        case Landform::terrain:
            return std::nullopt;
    }
    return std::nullopt;
}

class ArrowOverlay : public Overlay {
  public:
    ArrowOverlay(const OverlayScene& on, std::size_t number)
        : view_(on.scene.view),
          last_step_(on.scene.run.steps),
          flat_(on.flat),
          moves_(on.camera_moves),
          direction_(direction_of(on)),
          winds_(direction_ || flat_ ? std::vector<GroundWind>() : ground_winds(on.first)) {
        if (!flat_) block_ = framed_block(view_, on.shown);
        if (flat_ && !direction_) {
            throw KeyError(
                overlay_key(number, "kind"),
                fmt::format("overlay.{} shows the wind, but this scene has none", number));
        }
    }

    [[nodiscard]] FurnitureSize size(const Canvas& canvas) const override {
        const double font = canvas.font_size();
        const Sizes sizes = sizes_over_run(canvas);
        if (flat_) return sizes.arrow;
        if (sizes.arrow.width <= 0.0) return sizes.compass;
        return {sizes.arrow.width + apart * font + sizes.compass.width,
                std::max(sizes.arrow.height, sizes.compass.height)};
    }
    [[nodiscard]] std::string appearance_in(const OverlayFrame& frame) const override {
        const GroundAxes axes = axes_of(frame);
        const std::vector<GroundWind> winds = winds_in(frame);
        const auto blowing = std::ranges::find(winds, true, &GroundWind::blows) - winds.begin();
        return fmt::format("{} {} {} {} {}", axes.east.x, axes.east.y, axes.north.x, axes.north.y,
                           blowing);
    }
    void draw(Canvas& canvas, const CanvasBox& box, const OverlayFrame& frame) const override {
        const GroundAxes axes = axes_of(frame);
        const Sizes sizes = sizes_over_run(canvas);
        const CanvasBox left{box.x, box.y, sizes.arrow.width, box.height};
        draw_ground_winds(canvas, winds_in(frame), axes, left);
        if (direction_) {
            draw_ground_arrow(
                canvas, *direction_, axes,
                centred(left, ground_arrow_size(canvas, *direction_, axes, arrow_length)), {},
                arrow_length);
        }
        if (flat_) return;
        const CanvasBox right{box.right() - sizes.compass.width, box.y, sizes.compass.width,
                              box.height};
        draw_compass(canvas, axes, centred(right, compass_size(canvas, axes, needle_length)), {},
                     needle_length);
    }

  private:
    /// The most that both take while the camera turns.
    struct Sizes {
        FurnitureSize arrow;
        FurnitureSize compass;
    };

    static constexpr double apart = 0.9;  // font sizes, as are the lengths
    static constexpr double arrow_length = 3.4;
    static constexpr double needle_length = 3.0;

    static CanvasBox centred(const CanvasBox& within, const FurnitureSize& size) {
        return {within.x + 0.5 * (within.width - size.width),
                within.y + 0.5 * (within.height - size.height), size.width, size.height};
    }

    static void take(FurnitureSize& most, const FurnitureSize& size) {
        most = {std::max(most.width, size.width), std::max(most.height, size.height)};
    }

    /// Those that cancel, so that no arrow stands for them all.
    [[nodiscard]] std::vector<GroundWind> winds_in(const OverlayFrame& frame) const {
        if (winds_.empty()) return {};
        return ground_winds(frame.snapshot);
    }

    [[nodiscard]] GroundAxes axes_of(const OverlayFrame& frame) const {
        if (frame.camera != nullptr && !flat_) return visible_axes_of(levelled(*frame.camera));
        return axes_at(frame.snapshot.step);
    }

    [[nodiscard]] GroundAxes axes_at(std::int64_t step) const {
        if (flat_) return map_axes();
        return visible_axes_of(camera_at_step(view_, block_, step, last_step_));
    }

    /// From above at any azimuth, where arrows are longest.
    [[nodiscard]] GroundAxes axes_turned(double azimuth) const {
        CameraSettings settings;
        settings.projection = Projection::orthographic;
        settings.azimuth = azimuth;
        settings.elevation = 80.0;
        settings.distance = 1.0;
        const double aspect =
            static_cast<double>(view_.image.width) / static_cast<double>(view_.image.height);
        return visible_axes_of(place_camera(settings, block_, aspect, 0.0));
    }

    /// As the camera sees directions on the ground, wherever it stands; from low over the ground,
    /// where they would be lines, as from higher up.
    [[nodiscard]] Camera levelled(const Camera& camera) const {
        constexpr double least_down = 0.42;  // of the view's direction: 25 degrees
        Camera level = camera;
        const double ahead = glm::length(glm::dvec2(camera.forward));
        if (-camera.forward.z < least_down && ahead > 0.0) {
            const glm::dvec2 along = glm::dvec2(camera.forward) / ahead;
            const double across = std::sqrt(1.0 - least_down * least_down);
            level.forward = {across * along.x, across * along.y, -least_down};
            level.right = {along.y, -along.x, 0.0};
            level.up = glm::cross(level.right, level.forward);
        }
        level.perspective = false;
        level.half = {
            static_cast<double>(view_.image.width) / static_cast<double>(view_.image.height), 1.0};
        level.eye = -3.0 * camera.forward;
        return level;
    }

    [[nodiscard]] GroundAxes visible_axes_of(const Camera& camera) const {
        return visible_axes({camera,
                             block_,
                             {0.0, 0.0, static_cast<double>(view_.image.width),
                              static_cast<double>(view_.image.height)}});
    }

    [[nodiscard]] Sizes sizes_over_run(const Canvas& canvas) const {
        constexpr std::int64_t most_looks = 90;  // over a turn: 4 degrees of a whole circle
        const bool turns = !flat_ && view_.camera.turn != 0.0;
        const std::int64_t looks = moves_  ? most_looks
                                   : turns ? std::min(last_step_, most_looks)
                                           : 0;
        Sizes sizes;
        for (std::int64_t i = 0; i <= looks; ++i) {
            const auto share =
                static_cast<double>(i) / static_cast<double>(std::max<std::int64_t>(looks, 1));
            const GroundAxes axes =
                moves_ && !flat_
                    ? axes_turned(360.0 * share)
                    : axes_at(static_cast<std::int64_t>(share * static_cast<double>(last_step_)));
            if (direction_)
                take(sizes.arrow, ground_arrow_size(canvas, *direction_, axes, arrow_length));
            take(sizes.arrow, ground_winds_size(canvas, winds_, axes));
            take(sizes.compass, compass_size(canvas, axes, needle_length));
        }
        return sizes;
    }

    View view_;
    std::int64_t last_step_;
    bool flat_;
    bool moves_;
    std::optional<GroundDirection> direction_;
    std::vector<GroundWind> winds_;  ///< where they cancel
    Block block_;
};

}  // namespace

/// A level bar of a round length, at most a fifth of the picture's width: true everywhere in a map
/// and, for lengths across the picture, in an orthographic view; in perspective at the depth of
/// what the camera looks at, which its text says. Under a moving camera it is that of each frame.
/// None over a section's flat figure, whose axes have the scale.
std::unique_ptr<Overlay> make_scale_bar_overlay(const OverlayScene& on, std::size_t number) {
    if (on.flat) {
        throw KeyError(overlay_key(number, "kind"),
                       fmt::format("overlay.{} is a scale bar, which a section's figure does not "
                                   "need: its axes have the scale",
                                   number));
    }
    return std::make_unique<ScaleBarOverlay>(on);
}

/// The direction of the wind (sand and air) or of the slope that water runs down (a tilted plane),
/// as the camera sees the ground at the frame, beside a compass; where several winds cancel, all of
/// them, the one that blows darker; a compass alone where the model has neither. Over a section's
/// flat figure the wind alone, which blows to the right.
std::unique_ptr<Overlay> make_arrow_overlay(const OverlayScene& on, std::size_t number) {
    return std::make_unique<ArrowOverlay>(on, number);
}

}  // namespace fumon
