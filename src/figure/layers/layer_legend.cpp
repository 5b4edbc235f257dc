#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "figure/layers/draw_layers.h"
#include "figure/layers/layer_inks.h"

namespace fumon {

namespace {

constexpr double sign_width_em = 1.8;  // font sizes, as are the others
constexpr double sign_height_em = 0.8;
constexpr double sign_gap_em = 0.5;
constexpr double line_height_em = 1.35;
constexpr double text_size_em = 0.85;
constexpr double widest_line_em = 0.5;  // of a line's sign

bool has_shape(const PlacedLayer& layer, LayerShape shape) {
    return std::ranges::any_of(
        layer.features, [shape](const LayerFeature& feature) { return feature.shape == shape; });
}

void draw_sign(Canvas& canvas, const CanvasBox& box, const LayerSettings& settings,
               const PlacedLayer& layer, double pixel) {
    const double font = canvas.font_size();
    const double width = settings.ground_width > 0.0
                             ? 0.3 * font
                             : std::min(settings.width * pixel, widest_line_em * font);
    const CanvasPoint middle = box.middle();
    std::vector<double> dashes;
    for (const double length : settings.dash) dashes.push_back(length * pixel);
    if (has_shape(layer, LayerShape::areas)) {
        canvas.fill(box, area_ink(settings));
        if (width > 0.0) {
            canvas.stroke(std::array<CanvasPoint, 5>{{{box.x, box.y},
                                                      {box.right(), box.y},
                                                      {box.right(), box.bottom()},
                                                      {box.x, box.bottom()},
                                                      {box.x, box.y}}},
                          width, line_ink(settings), dashes);
        }
    } else if (has_shape(layer, LayerShape::lines) || settings.data == LayerData::contours ||
               settings.data == LayerData::streams) {
        canvas.stroke(std::array<CanvasPoint, 2>{{{box.x, middle.y}, {box.right(), middle.y}}},
                      width, line_ink(settings), dashes);
    } else {
        LayerSettings sign = settings;
        sign.marker_size = std::min(settings.marker_size, sign_height_em * font / pixel);
        draw_layer_marker(canvas, sign, middle, pixel, 1.0);
    }
}

}  // namespace

bool has_legend(std::span<const LayerSettings> settings) {
    return std::ranges::any_of(settings,
                               [](const LayerSettings& layer) { return !layer.legend.empty(); });
}

FurnitureSize layer_legend_size(const Canvas& canvas, std::span<const LayerSettings> settings) {
    FurnitureSize size;
    const double font = canvas.font_size();
    for (const LayerSettings& layer : settings) {
        if (layer.legend.empty()) continue;
        const double text = canvas.text_size(layer.legend, text_size_em)[0];
        size.width = std::max(size.width, (sign_width_em + sign_gap_em) * font + text);
        size.height += line_height_em * font;
    }
    return size;
}

void draw_layer_legend(Canvas& canvas, const CanvasPoint& corner,
                       std::span<const LayerSettings> settings, const PlacedLayers& placed,
                       double pixel) {
    const double font = canvas.font_size();
    double top = corner.y;
    for (std::size_t n = 0; n < settings.size(); ++n) {
        if (settings[n].legend.empty()) continue;
        const double middle = top + 0.5 * line_height_em * font;
        draw_sign(canvas,
                  {corner.x, middle - 0.5 * sign_height_em * font, sign_width_em * font,
                   sign_height_em * font},
                  settings[n], placed.layers[n], pixel);
        canvas.write(settings[n].legend, {corner.x + (sign_width_em + sign_gap_em) * font, middle},
                     {0.0, 0.5}, black_ink, text_size_em);
        top += line_height_em * font;
    }
}

}  // namespace fumon
