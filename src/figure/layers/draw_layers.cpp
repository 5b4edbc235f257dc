#include "figure/layers/draw_layers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>

#include "figure/layers/layer_inks.h"

namespace fumon {

namespace {

constexpr double hidden_opacity = 0.3;
constexpr double halo_em = 0.14;  // around labels
constexpr double label_gap_em = 0.25;
constexpr double fade_em = 0.6;  // clearance at which a label of a moving picture is whole

Ink faded(Ink ink, double opacity) {
    ink.opacity *= opacity;
    return ink;
}

void draw_lines(Canvas& canvas, const LayerSettings& settings, const SeenFeature& feature,
                const LayerStyle& style) {
    const Ink ink = line_ink(settings);
    std::vector<double> dashes;
    for (const double length : settings.dash) dashes.push_back(length * style.pixel);
    for (const SeenPart& part : feature.parts) {
        const Ink own = faded(ink, part.hidden ? hidden_opacity : 1.0);
        if (settings.ground_width > 0.0)
            canvas.fill(part.points, own);
        else
            canvas.stroke(part.points, feature.width * settings.width * style.pixel, own, dashes);
    }
}

void draw_points(Canvas& canvas, const LayerSettings& settings, const SeenFeature& feature,
                 const LayerStyle& style) {
    for (const SeenPart& part : feature.parts)
        draw_layer_marker(canvas, settings, part.points.front(), style.pixel,
                          part.hidden ? hidden_opacity : 1.0);
}

/// Labels that keep away from one another.
class LayerLabels {
  public:
    LayerLabels(Canvas& canvas, const CanvasBox& frame, const std::vector<CanvasBox>& taken,
                const LayerStyle& style)
        : canvas_(canvas), frame_(frame), style_(style) {
        for (const CanvasBox& box : taken) shown_.push_back({box, 1.0, nullptr});
    }

    /// Keeps the labels of other features off a marker.
    void keep_off(const LayerSettings& settings, const SeenFeature& feature) {
        if (settings.marker == LayerMarker::none || feature.shape != LayerShape::points) return;
        const double size = settings.marker_size * style_.pixel;
        for (const SeenPart& part : feature.parts) {
            const CanvasPoint& at = part.points.front();
            shown_.push_back({{at.x - 0.5 * size, at.y - 0.5 * size, size, size}, 1.0, &feature});
        }
    }

    void write(const LayerSettings& settings, const SeenFeature& feature) {
        if (!feature.anchor || feature.label.empty()) return;
        const auto [width, height] = canvas_.text_size(feature.label, settings.label_size);
        const double room = label_gap_em * settings.label_size * canvas_.font_size();
        const double away = feature.shape == LayerShape::points
                                ? 0.5 * settings.marker_size * style_.pixel + room
                            : feature.shape == LayerShape::lines
                                ? 0.5 * feature.width * settings.width * style_.pixel + room
                                : 0.0;
        const CanvasPoint at = feature.anchor->points.front();
        for (const CanvasPoint& side : sides_of(feature.shape)) {
            const CanvasBox box{at.x + side.x * (away + 0.5 * width) - 0.5 * width,
                                at.y + side.y * (away + 0.5 * height) - 0.5 * height, width,
                                height};
            const double share = share_shown(box, room, feature);
            if (share <= 0.0) continue;
            shown_.push_back({box, share, &feature});
            write_with_halo(feature.label, box, settings,
                            share * (feature.anchor->hidden ? hidden_opacity : 1.0));
            return;
        }
    }

  private:
    struct Shown {
        CanvasBox box;
        double share = 1.0;
        const SeenFeature* of = nullptr;  ///< whose label keeps no distance; null: nobody's
    };

    [[nodiscard]] std::vector<CanvasPoint> sides_of(LayerShape shape) const {
        std::vector<CanvasPoint> sides;
        if (shape == LayerShape::points) sides = {{1.0, 0.0}, {-1.0, 0.0}, {0.0, -1.0}, {0.0, 1.0}};
        if (shape == LayerShape::lines) sides = {{0.0, -1.0}, {0.0, 1.0}, {1.0, 0.0}, {-1.0, 0.0}};
        if (shape == LayerShape::areas) sides = {{0.0, 0.0}};
        if (style_.moves) sides.resize(1);
        return sides;
    }

    /// How far a label may be shown there; all or nothing in pictures that hold still.
    [[nodiscard]] double share_shown(const CanvasBox& box, double room,
                                     const SeenFeature& feature) const {
        if (!within(box, frame_)) return 0.0;
        double share = 1.0;
        const double whole = style_.moves ? fade_em * canvas_.font_size() : room;
        for (const Shown& other : shown_) {
            if (other.of == &feature) continue;
            const double across = std::max(other.box.x - box.right(), box.x - other.box.right());
            const double down = std::max(other.box.y - box.bottom(), box.y - other.box.bottom());
            const double clear = std::clamp(std::max(across, down) / whole, 0.0, 1.0);
            share = std::min(share, 1.0 - other.share * (1.0 - clear));
        }
        if (style_.moves) {
            const double edge = std::min({box.x - frame_.x, frame_.right() - box.right(),
                                          box.y - frame_.y, frame_.bottom() - box.bottom()});
            return share * std::clamp(edge / whole, 0.0, 1.0);
        }
        return share < 1.0 ? 0.0 : 1.0;
    }

    void write_with_halo(const std::string& text, const CanvasBox& box,
                         const LayerSettings& settings, double opacity) {
        const double radius = halo_em * settings.label_size * canvas_.font_size();
        // Twelve pale copies, which together are as good as opaque behind the letters.
        constexpr std::array<CanvasPoint, 12> around{{{1.0, 0.0},
                                                      {0.866, 0.5},
                                                      {0.5, 0.866},
                                                      {0.0, 1.0},
                                                      {-0.5, 0.866},
                                                      {-0.866, 0.5},
                                                      {-1.0, 0.0},
                                                      {-0.866, -0.5},
                                                      {-0.5, -0.866},
                                                      {0.0, -1.0},
                                                      {0.5, -0.866},
                                                      {0.866, -0.5}}};
        constexpr Ink halo{1.0, 1.0, 1.0, 0.35};
        for (const CanvasPoint& way : around)
            canvas_.write(text, {box.x + radius * way.x, box.y + radius * way.y}, {0.0, 0.0},
                          faded(halo, opacity), settings.label_size);
        canvas_.write(text, {box.x, box.y}, {0.0, 0.0}, faded({0.08, 0.08, 0.08, 1.0}, opacity),
                      settings.label_size);
    }

    Canvas& canvas_;
    CanvasBox frame_;
    const LayerStyle& style_;
    std::vector<Shown> shown_;
};

}  // namespace

void draw_layers(Canvas& canvas, const CanvasBox& frame, std::span<const LayerSettings> settings,
                 const std::vector<SeenLayer>& layers, const std::vector<CanvasBox>& taken,
                 const LayerStyle& style) {
    const CanvasClip clip(canvas, frame);
    for (std::size_t n = 0; n < layers.size(); ++n) {
        for (const SeenFeature& feature : layers[n].features) {
            if (!feature.rings.empty()) canvas.fill_rings(feature.rings, area_ink(settings[n]));
            if (feature.shape == LayerShape::points)
                draw_points(canvas, settings[n], feature, style);
            else
                draw_lines(canvas, settings[n], feature, style);
        }
    }
    LayerLabels labels(canvas, frame, taken, style);
    for (std::size_t n = 0; n < layers.size(); ++n) {
        for (const SeenFeature& feature : layers[n].features) labels.keep_off(settings[n], feature);
    }
    for (std::size_t n = 0; n < layers.size(); ++n) {
        for (const SeenFeature& feature : layers[n].features) labels.write(settings[n], feature);
    }
}

}  // namespace fumon
