#include "figure/overlays/overlay_places.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace fumon {

namespace {

constexpr std::size_t corners = 6;

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

}  // namespace

std::vector<CanvasBox> stacked_boxes(std::span<const OverlayPiece> pieces, double width,
                                     double height, double gap) {
    const double edge = std::round(gap);
    std::array<double, corners> heights{};
    for (const OverlayPiece& piece : pieces)
        heights.at(static_cast<std::size_t>(piece.corner)) += std::ceil(piece.size.height) + edge;
    std::array<double, corners> next{};  // the top of each corner's next piece
    for (std::size_t corner = 0; corner < corners; ++corner)
        next.at(corner) =
            is_lower(static_cast<OverlayCorner>(corner)) ? height - heights.at(corner) : edge;
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

}  // namespace fumon
