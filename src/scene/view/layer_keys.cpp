#include <array>
#include <charconv>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "base/limits.h"
#include "scene/view/view_keys.h"

namespace fumon {

namespace {

void list_layer_marks(LayerSettings& layer, const std::string& path, KeyTable& table) {
    table.choice(path + ".marker", layer.marker,
                 {{LayerMarker::none, "none", "labels alone"},
                  {LayerMarker::circle, "circle", "a disc"},
                  {LayerMarker::square, "square", "a square"},
                  {LayerMarker::triangle, "triangle", "a triangle"},
                  {LayerMarker::cross, "cross", "two lines"}},
                 {.help = "of points"});
    table.real(path + ".marker_size", layer.marker_size,
               {.unit = "pixels", .range = {1, 500}, .help = "how wide markers are"});
    table.text(
        path + ".label", layer.label,
        {.help = "a field of the file, or of other data the one that layer.data names, whose "
                 "values stand beside its features; empty: none"});
    table.real(path + ".label_size", layer.label_size,
               {.unit = "font sizes",
                .range = {0.2, 10},
                .help = "of labels; a font size is a 36th of the picture's shorter side, at least "
                        "10 pixels"});
    table.choice(path + ".hidden", layer.hidden,
                 {{BehindRidges::hide, "hide", "not drawn"},
                  {BehindRidges::faint, "faint", "drawn faintly"},
                  {BehindRidges::show, "show", "drawn as if nothing hid it"}},
                 {.help = "lines, points and labels behind ridges"});
    table.text(path + ".legend", layer.legend,
               {.help = "what the layer shows, for the overlay \"legend\" and the legends of "
                        "figures; empty: no entry"});
}

void list_layer_data(LayerSettings& layer, const std::string& path, KeyTable& table) {
    table.choice(
        path + ".data", layer.data,
        {{LayerData::file, "file", "layer.file"},
         {LayerData::contours, "contours",
          "lines of equal height, every fifth thicker; the label \"height\""},
         {LayerData::streams, "streams",
          "where water gathers (D8), wider from order to order; the label \"order\""},
         {LayerData::gauges, "gauges", "the points and lines of [[gauge]]; the label \"name\""}},
        {.help = "what is laid over the bed"});
    table.word_or_real(path + ".interval", layer.interval,
                       {{"auto", "a round interval: up to 16 lines"}},
                       {.unit = "m",
                        .range = {0, 1e6, true},
                        .help = "of contours; in model heights where there are no metres"});
    table.real(path + ".channel_area", layer.channel_area,
               {.unit = "m2",
                .range = {0, 1e15},
                .help = "that drains through the source of a stream, at least (cells without "
                        "metres); 0: a 500th of the ground"});
    table.integer(path + ".least_order", layer.least_order,
                  {.range = {1, 20}, .help = "of the streams that are drawn, after Strahler"});
}

void list_layer_keys(LayerSettings& layer, const std::string& path, KeyTable& table) {
    list_layer_data(layer, path, table);
    table.text(path + ".file", layer.file,
               {.help = "GeoJSON, GeoPackage, shapefile or another vector file of GDAL's; "
                        "relative to the scene file, or with --set to the working folder"});
    table.text(path + ".name", layer.name,
               {.help = "the layer within the file; empty: the only one"});
    table.text(path + ".where", layer.where,
               {.help = "which features: a condition on the file's fields as in SQL, \"kind = "
                        "'stream' AND order > 2\"; empty: all"});
    table.text(path + ".colour", layer.colour, {.help = "of lines and markers, \"#rrggbb\""});
    table.real(path + ".width", layer.width,
               {.unit = "pixels",
                .range = {0, 500},
                .help = "of lines and of the borders of areas, in figures of 1/96 inch; 0: none"});
    table.real(path + ".ground_width", layer.ground_width,
               {.unit = "m or sites",
                .range = {0, largest_coordinate},
                .help = "of lines on the ground, in the place of width; 0: width counts"});
    table.real(path + ".opacity", layer.opacity, {.range = {0, 1}, .help = "of lines and markers"});
    table.real_list(path + ".dash", layer.dash, 0, 16,
                    {.unit = "pixels",
                     .range = {0, 10000},
                     .help = "lengths of dashes and gaps in turn; empty: solid"});
    table.text(path + ".fill", layer.fill,
               {.help = "of areas, \"#rrggbb\"; empty: the colour of the lines"});
    table.real(path + ".fill_opacity", layer.fill_opacity,
               {.range = {0, 1}, .help = "of areas, whose ground shows through; 0: borders alone"});
    list_layer_marks(layer, path, table);
}

}  // namespace

std::optional<std::array<double, 3>> layer_colour(std::string_view text) {
    constexpr std::size_t length = 7;
    if (text.size() != length || text.front() != '#') return std::nullopt;
    std::array<double, 3> colour{};
    for (std::size_t channel = 0; channel < colour.size(); ++channel) {
        const std::string_view digits = text.substr(1 + 2 * channel, 2);
        unsigned int level = 0;
        const auto [end, fault] =
            std::from_chars(digits.data(), digits.data() + digits.size(), level, 16);
        if (fault != std::errc{} || end != digits.data() + digits.size()) return std::nullopt;
        constexpr double full = 255.0;
        colour[channel] = level / full;
    }
    return colour;
}

void list_layers(std::vector<LayerSettings>& layers, KeyTable& table) {
    table.tables(
        "layer", layers,
        "lines, points and areas over the bed: of a vector file, contours, streams, gauges",
        list_layer_keys);
}

}  // namespace fumon
