#include "figure/overlays/frame_overlays.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

#include "base/elementary.h"
#include "base/error.h"
#include "figure/canvas/furniture.h"
#include "figure/canvas/layers.h"
#include "figure/overlays/overlay_text.h"
#include "figure/words/chosen_words.h"
#include "render/view/shown_snapshot.h"
#include "scene/scene.h"

namespace fumon {

namespace {

/// One thing to place in a picture.
struct OverlayPiece {
    OverlayCorner corner = OverlayCorner::upper_left;
    FurnitureSize size;  ///< pixels
};

constexpr std::size_t corner_count = 6;

bool is_lower(OverlayCorner corner) {
    return corner == OverlayCorner::lower_left || corner == OverlayCorner::lower_middle ||
           corner == OverlayCorner::lower_right;
}

/// 0 at the left, 1 at the right.
double place_across(OverlayCorner corner) {
    if (corner == OverlayCorner::upper_left || corner == OverlayCorner::lower_left) return 0.0;
    if (corner == OverlayCorner::upper_right || corner == OverlayCorner::lower_right) return 1.0;
    return 0.5;
}

/// The boxes of pieces in a picture, whole pixels: those of a corner below one another, `gap`
/// pixels apart and from the edges; the upper ones below `under` pixels on which something else
/// stands.
std::vector<CanvasBox> stacked_boxes(std::span<const OverlayPiece> pieces, double width,
                                     double height, double gap, double under) {
    const double edge = std::round(gap);
    const double top_edge = under > 0.0 ? std::round(under + 0.5 * edge) : edge;
    std::array<double, corner_count> heights{};
    for (const OverlayPiece& piece : pieces)
        heights.at(static_cast<std::size_t>(piece.corner)) += std::ceil(piece.size.height) + edge;
    std::array<double, corner_count> next{};  // the top of each corner's next piece
    for (std::size_t corner = 0; corner < corner_count; ++corner)
        next.at(corner) =
            is_lower(static_cast<OverlayCorner>(corner)) ? height - heights.at(corner) : top_edge;
    std::vector<CanvasBox> boxes;
    boxes.reserve(pieces.size());
    for (const OverlayPiece& piece : pieces) {
        const double across = std::ceil(piece.size.width);
        const double down = std::ceil(piece.size.height);
        double& top = next.at(static_cast<std::size_t>(piece.corner));
        const double left =
            std::round(edge + place_across(piece.corner) * (width - 2.0 * edge - across));
        boxes.push_back({left, top, across, down});
        top += down + edge;
    }
    return boxes;
}

/// The first piece that leaves the picture or overlaps one before it; their count where none does.
std::size_t first_misfit(std::span<const CanvasBox> boxes, double width, double height) {
    const CanvasBox picture{0.0, 0.0, width, height};
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (!within(boxes[i], picture)) return i;
        for (std::size_t j = 0; j < i; ++j) {
            if (overlap(boxes[i], boxes[j])) return i;
        }
    }
    return boxes.size();
}

constexpr double plate_padding_em = 0.45;       // of the plate around an overlay, font sizes
constexpr double plate_corner_radius_em = 0.3;  // radius of the plate's corners
constexpr double plate_gap_em = 0.55;  // between plates, and from the edges, of the usual font size
constexpr double least_font_size_pixels = 6.0;
constexpr double small_text_ratio = 0.75;  // of an overlay that fills the picture
constexpr double shrink_ratio = 0.93;      // from one try to the next

std::unique_ptr<Overlay> make_overlay(const OverlayScene& on, std::size_t number) {
#define FUMON_MAKER(name, word, shows, help) make_##name##_overlay,
    constexpr std::array makers{FUMON_OVERLAY_KINDS(FUMON_MAKER)};
#undef FUMON_MAKER
    return makers.at(static_cast<std::size_t>(on.scene.view.overlays[number].kind))(on, number);
}

double usual_font(const ImageSettings& image) {
    constexpr double share = 1.0 / 36.0;
    constexpr double least = 10.0;
    return std::max(least, share * static_cast<double>(std::min(image.width, image.height)));
}

/// A rectangle with round corners.
void draw_rounded(Canvas& canvas, double width, double height, double radius, const Ink& ink) {
    constexpr int points = 8;  // of a quarter circle
    std::vector<CanvasPoint> outline;
    const std::array<CanvasPoint, 4> middles{{{width - radius, height - radius},
                                              {radius, height - radius},
                                              {radius, radius},
                                              {width - radius, radius}}};
    for (std::size_t corner = 0; corner < middles.size(); ++corner) {
        for (int i = 0; i <= points; ++i) {
            const double angle = 0.5 * std::numbers::pi *
                                 (static_cast<double>(corner) + static_cast<double>(i) / points);
            outline.push_back({middles.at(corner).x + radius * elementary::cos(angle),
                               middles.at(corner).y + radius * elementary::sin(angle)});
        }
    }
    canvas.fill(outline, ink);
}

}  // namespace

/// An overlay with its layer as last drawn, used again while its text is the same.
struct FrameOverlays::DrawnOverlay {
    std::unique_ptr<Overlay> overlay;
    double opacity = 0.0;
    bool shadowed = false;  ///< pale letters with a shadow, no plate
    bool pale = false;      ///< pale letters on a dark plate
    std::optional<std::string> look;
    CanvasLayer layer;

    void draw(Image& image, const PlacedOverlay& place, const OverlayFrame& frame, double of_all) {
        if (std::string appearance_now = overlay->appearance_in(frame); look != appearance_now) {
            look = std::move(appearance_now);
            layer = drawn_layer(place, frame);
        }
        composite_over(image, layer, static_cast<int>(place.box.x), static_cast<int>(place.box.y),
                       of_all);
    }

  private:
    [[nodiscard]] CanvasLayer drawn_layer(const PlacedOverlay& place,
                                          const OverlayFrame& frame) const {
        Canvas canvas(static_cast<int>(place.box.width), static_cast<int>(place.box.height),
                      place.font_size, CanvasGround::transparent);
        const bool fills = overlay->fills_picture();
        const double padding = plate_padding_em * place.font_size;
        const double room = fills ? 0.0 : padding;
        if (opacity > 0.0 && !fills) {
            draw_rounded(canvas, place.box.width, place.box.height,
                         plate_corner_radius_em * place.font_size, {1.0, 1.0, 1.0, opacity});
        }
        overlay->draw(canvas,
                      {room, room, place.box.width - 2.0 * room, place.box.height - 2.0 * room},
                      frame);
        if (pale && opacity > 0.0) return inverted(canvas.layer());
        if (!shadowed && !pale) return canvas.layer();
        return with_soft_shadow(inverted(canvas.layer()),
                                std::max(2, static_cast<int>(0.4 * padding)));
    }
};

FrameOverlays::FrameOverlays(const Scene& scene, const Snapshot& first, const OverlayStyle& style)
    : words_(picture_words(scene.view.image)) {
    const LanguageScope speaking(words_);
    const std::vector<OverlaySettings>& overlays = scene.view.overlays;
    const bool flat = first.section && scene.view.look.mode == ViewMode::figure;
    const std::optional<Snapshot> shown = shown_snapshot(first, scene.view);
    const OverlayScene on{
        scene,          first,          shown ? *shown : first, flat, style.camera_moves,
        style.end_time, style.time_note};
    for (std::size_t number = 0; number < overlays.size(); ++number) {
        if (!overlays[number].show) continue;
        // A colour bar's, a plot's and a map's colours mean something.
        const OverlayKind kind = overlays[number].kind;
        const bool neutral = kind != OverlayKind::colour_bar && kind != OverlayKind::plot &&
                             kind != OverlayKind::inset_map;
        const bool shadowed = style.shadowed && neutral;
        DrawnOverlay drawn;
        drawn.overlay = make_overlay(on, number);
        drawn.opacity = shadowed ? 0.0 : overlays[number].opacity;
        drawn.shadowed = shadowed;
        drawn.pale =
            neutral && kind != OverlayKind::legend && overlays[number].ink == OverlayInk::white;
        const bool fills = drawn.overlay->fills_picture();
        (fills ? over_all_ : drawn_).push_back(std::move(drawn));
        (fills ? over_all_placed_ : placed_).push_back({number, {}, 0.0});
    }
    if (scene.view.look.draws_contours() && !first.section && first.bed.ny() > 1)
        contours_ = std::make_unique<FrameContours>(on, usual_font(scene.view.image));
    if (FrameLayers::has_any(on))
        layers_ = std::make_unique<FrameLayers>(on, usual_font(scene.view.image));
    const auto width = static_cast<double>(scene.view.image.width);
    const auto height = static_cast<double>(scene.view.image.height);
    const double usual = usual_font(scene.view.image);
    for (double font = usual;; font *= shrink_ratio) {
        const double tried = std::max(font, least_font_size_pixels);
        std::vector<OverlayPiece> pieces;
        pieces.reserve(placed_.size());
        for (std::size_t i = 0; i < placed_.size(); ++i) {
            const OverlaySettings& settings = overlays[placed_[i].number];
            placed_[i].font_size = settings.font_size.is_word() ? tried : settings.font_size.value;
            const Canvas ruler(1, 1, placed_[i].font_size);
            const FurnitureSize size = drawn_[i].overlay->size(ruler);
            system_fonts_ = system_fonts_ || ruler.uses_system_fonts();
            const double room = 2.0 * plate_padding_em * placed_[i].font_size;
            pieces.push_back({settings.corner, {size.width + room, size.height + room}});
        }
        const auto boxes = stacked_boxes(pieces, width, height,
                                         std::max(plate_gap_em * tried, style.edge), style.under);
        const std::size_t misfit = first_misfit(boxes, width, height);
        if (misfit == boxes.size()) {
            for (std::size_t i = 0; i < boxes.size(); ++i) placed_[i].box = boxes[i];
            for (std::size_t i = 0; i < over_all_.size(); ++i) {
                const WordOrReal& size = overlays[over_all_placed_[i].number].font_size;
                over_all_placed_[i].font_size =
                    size.is_word() ? small_text_ratio * usual : size.value;
                over_all_placed_[i].box = {0.0, 0.0, width, height};
                over_all_[i].overlay->avoid_boxes(boxes, over_all_[i].opacity);
            }
            return;
        }
        if (font > least_font_size_pixels) continue;
        const std::size_t number = placed_[misfit].number;
        throw KeyError(
            overlay_key(number, overlays[number].font_size.is_word() ? "kind" : "font_size"),
            fmt::format(
                "overlay.{} does not fit into a picture of {} x {} pixels beside the overlays "
                "before it; take another corner, a smaller size or font_size, or a larger image",
                number, scene.view.image.width, scene.view.image.height));
    }
}

FrameOverlays::~FrameOverlays() = default;

void FrameOverlays::draw(Image& image, const OverlayFrame& frame, double opacity) {
    const LanguageScope speaking(words_);
    std::vector<CanvasBox> taken;
    for (const PlacedOverlay& place : placed_) taken.push_back(place.box);
    if (contours_) contours_->draw(image, frame, taken, opacity);
    if (layers_) layers_->draw(image, frame, taken, opacity);
    for (std::size_t i = 0; i < over_all_.size(); ++i)
        over_all_[i].draw(image, over_all_placed_[i], frame, opacity);
    for (std::size_t i = 0; i < drawn_.size(); ++i)
        drawn_[i].draw(image, placed_[i], frame, opacity);
}

}  // namespace fumon
