#pragma once

namespace fumon {

/// A place on a canvas, rightward and downward from its upper left corner, in the canvas's units.
struct CanvasPoint {
    double x = 0.0;
    double y = 0.0;
};

struct CanvasBox {
    double x = 0.0;  ///< left
    double y = 0.0;  ///< top
    double width = 0.0;
    double height = 0.0;

    [[nodiscard]] double right() const { return x + width; }
    [[nodiscard]] double bottom() const { return y + height; }
    [[nodiscard]] CanvasPoint middle() const { return {x + 0.5 * width, y + 0.5 * height}; }
};

/// A box and `room` around it.
inline CanvasBox grown(const CanvasBox& box, double room) {
    return {box.x - room, box.y - room, box.width + 2.0 * room, box.height + 2.0 * room};
}

/// Whether boxes overlap by more than their edges, within a tolerance of `slack`.
inline bool overlap(const CanvasBox& a, const CanvasBox& b, double slack = 0.0) {
    return a.x + slack < b.right() && b.x + slack < a.right() && a.y + slack < b.bottom() &&
           b.y + slack < a.bottom();
}

/// Whether `inner` lies within `outer`, with a tolerance of `slack`.
inline bool within(const CanvasBox& inner, const CanvasBox& outer, double slack = 0.0) {
    return inner.x >= outer.x - slack && inner.y >= outer.y - slack &&
           inner.right() <= outer.right() + slack && inner.bottom() <= outer.bottom() + slack;
}

inline bool within(const CanvasPoint& point, const CanvasBox& box) {
    return point.x >= box.x && point.x <= box.right() && point.y >= box.y &&
           point.y <= box.bottom();
}

}  // namespace fumon
