#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "keys/word_or_real.h"
#include "scene/view/drape.h"

namespace fumon {

enum class LayerData { file, contours, streams, gauges };
enum class LayerMarker { none, circle, square, triangle, cross };
enum class BehindRidges { hide, faint, show };

/// Lines, points and areas that are laid over the bed ([[layer]]): of a vector file, or what the
/// bed and the model have.
struct LayerSettings {
    LayerData data = LayerData::file;
    std::string file;
    std::string name;                  ///< the layer within the file; empty: the only one
    std::string where;                 ///< which of its features; empty: all
    WordOrReal interval{"auto", 0.0};  ///< of contours, metres or model heights
    double channel_area = 0.0;         ///< of streams, m² or cells; 0: a 500th of the ground
    std::int64_t least_order = 1;      ///< of streams, after Strahler
    std::string colour = "#b5651d";
    double width = 2.0;         ///< of lines, pixels
    double ground_width = 0.0;  ///< of lines, metres or sites; 0: `width` counts
    double opacity = 1.0;       ///< of lines and markers
    std::vector<double> dash;   ///< pixels; empty: solid
    std::string fill;           ///< colour of areas; empty: that of the lines
    double fill_opacity = 0.35;
    LayerMarker marker = LayerMarker::circle;
    double marker_size = 10.0;  ///< pixels
    std::string label;          ///< a field of the file; empty: none
    double label_size = 0.8;    ///< font sizes of the picture
    BehindRidges hidden = BehindRidges::hide;
    std::string legend;
};

/// sRGB, 0 … 1, of "#b5651d"; none where a text is no colour.
std::optional<std::array<double, 3>> layer_colour(std::string_view text);

enum class LayerShape { points, lines, areas };

/// A place over a bed: shares of its sides, eastward from its western and northward from its
/// southern edge.
using BedPlace = std::array<double, 2>;

/// A thing of a layer, clipped to the bed.
struct LayerFeature {
    LayerShape shape = LayerShape::lines;
    double width = 1.0;  ///< of lines, in widths of the layer
    /// Points one by one, or lines, among them the borders of areas; at most a cell from point to
    /// point.
    std::vector<std::vector<BedPlace>> lines;
    std::vector<std::vector<BedPlace>> rings;  ///< of areas, holes among them (even-odd)
    std::string label;
    std::optional<BedPlace> anchor;  ///< where its label stands
};

struct PlacedLayer {
    std::vector<LayerFeature> features;
};

/// The layers of a scene as they lie over its bed, in the order of [[layer]].
struct PlacedLayers {
    std::vector<PlacedLayer> layers;
    /// The drape of the scene, seen as far as it is, with the areas over it; null where there are
    /// no areas.
    std::shared_ptr<const Drape> areas{};
};

}  // namespace fumon
