#include "figure/colour_bar.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "figure/axes.h"
#include "figure/ticks.h"

namespace fumon {

Ink ColourScale::ink(double value) const {
    const double last = static_cast<double>(palette.size()) - 1.0;
    const double place = std::clamp((value - low) / (high - low), 0.0, 1.0) * last;
    const auto& colour = palette[static_cast<std::size_t>(std::lround(place))];
    constexpr double full = 255.0;
    return {colour[0] / full, colour[1] / full, colour[2] / full, 1.0};
}

void draw_colour_bar(Canvas& canvas, const CanvasBox& frame, const ColourScale& scale) {
    const double font = canvas.font_size();
    const double thin = std::max(1.0, 0.06 * font);
    const CanvasBox bar{std::round(frame.x + frame.width + 0.8 * font), frame.y,
                        std::max(1.0, std::round(0.9 * font)), frame.height};
    const double right = bar.x + bar.width;
    for (int row = 0; row < static_cast<int>(bar.height); ++row) {
        const double share = 1.0 - (row + 0.5) / bar.height;
        canvas.fill(CanvasBox{bar.x, bar.y + row, bar.width, 1.0},
                    scale.ink(std::lerp(scale.low, scale.high, share)));
    }
    outline(canvas, bar, thin);
    const Ticks ticks = linear_ticks(scale.low, scale.high,
                                     std::max(2, static_cast<int>(bar.height / (1.1 * font))));
    double widest = 0.0;
    for (std::size_t i = 0; i < ticks.values.size(); ++i) {
        widest = std::max(widest, canvas.text_size(ticks.labels[i], 0.85)[0]);
        const double share = (ticks.values[i] - scale.low) / (scale.high - scale.low);
        const double y = bar.y + bar.height * (1.0 - share);
        canvas.stroke(std::array<CanvasPoint, 2>{{{right, y}, {right + 0.25 * font, y}}}, thin, {});
        write_within(canvas, ticks.labels[i], 3.6 * font, {right + 0.4 * font, y}, {0.0, 0.5},
                     0.85);
    }
    write_within(canvas, scale.label, frame.height + 0.4 * font,
                 {right + 0.7 * font + std::min(widest, 3.6 * font), frame.y + 0.5 * frame.height},
                 {0.0, 0.5}, 0.95, true);
}

}  // namespace fumon
