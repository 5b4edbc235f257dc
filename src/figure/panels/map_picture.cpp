#include "figure/panels/map_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "base/elementary_power.h"
#include "base/error.h"
#include "base/find_named.h"
#include "figure/panels/axis_units.h"
#include "figure/words/words.h"
#include "numerics/percentile.h"
#include "render/view/water.h"

namespace fumon {

namespace {

/// How a quantity is shown when nothing else is asked for.
struct Quantity {
    std::string label;
    double factor = 1.0;  ///< from the unit of coloured_values to that of the label
    const char* palette = "viridis";
};

/// Of a field the label is empty: the snapshot names it.
Quantity quantity_of(Colouring colour_by, const WorldScale& scale,
                     std::pair<double, double> range) {
    const double largest = std::max(std::abs(range.first), std::abs(range.second));
    const auto height = [&](Word name, const char* palette) {
        const LengthUnit unit = height_unit(scale.in_metres, largest * scale.height_unit);
        return Quantity{labelled(name, unit.symbol), scale.height_unit / unit.length, palette};
    };
    switch (colour_by) {
        case Colouring::field:
            return {"", 1.0, "viridis"};
        case Colouring::field_change:
            return {"", 1.0, "vik"};
        case Colouring::slope:
            return {labelled("slope", "°"), 1.0, "viridis"};
        case Colouring::change:
            return height("change of height", "vik");
        case Colouring::water_depth: {
            const LengthUnit unit = height_unit(true, largest);
            return {labelled("depth", unit.symbol), 1.0 / unit.length, "cividis"};
        }
        case Colouring::speed:
            return {labelled("speed", "m/s"), 1.0, "viridis"};
        case Colouring::froude:
            return {word("Froude number"), 1.0, "viridis"};
        case Colouring::drainage:
            return {
                labelled("drainage area", scale.in_metres ? word("log10 m²") : word("log10 cells")),
                1.0, "viridis"};
        default:
            return height("height", "batlow");
    }
}

Palette palette_of(const LookSettings& look, const char* automatic) {
    Palette palette = read_palette(look.palette == "sand" ? automatic : look.palette);
    if (look.palette_reversed) std::reverse(palette.begin(), palette.end());
    return palette;
}

std::vector<double> known_values(const MapPicture& picture) {
    std::vector<double> known;
    known.reserve(picture.values.size());
    for (std::size_t i = 0; i < picture.values.size(); ++i) {
        if (picture.blank.empty() || picture.blank.values()[i] == 0)
            known.push_back(picture.values.values()[i]);
    }
    return known;
}

/// A picture of fewer cells, each the mean of those of `cells` × `cells` that have a value.
MapPicture coarser(const MapPicture& fine, int cells) {
    const int nx = (fine.values.nx() + cells - 1) / cells;
    const int ny = (fine.values.ny() + cells - 1) / cells;
    MapPicture coarse{Grid(nx, ny), Mask(nx, ny), {}, fine.scale, fine.colours, fine.background};
    if (!fine.light.empty()) coarse.light = Field<float>(nx, ny, 1.0F);
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x) {
            double sum = 0.0;
            double light = 0.0;
            int count = 0;
            for (int v = y * cells; v < std::min((y + 1) * cells, fine.values.ny()); ++v) {
                for (int u = x * cells; u < std::min((x + 1) * cells, fine.values.nx()); ++u) {
                    if (!fine.blank.empty() && fine.blank(u, v) != 0) continue;
                    sum += fine.values(u, v);
                    if (!fine.light.empty()) light += static_cast<double>(fine.light(u, v));
                    ++count;
                }
            }
            coarse.blank(x, y) = count == 0 ? 1 : 0;
            if (count == 0) continue;
            coarse.values(x, y) = sum / count;
            if (!fine.light.empty()) coarse.light(x, y) = static_cast<float>(light / count);
        }
    }
    return coarse;
}

/// Luminance as a display shows it: sRGB to linear and back (IEC 61966-2-1).
double linear(double display) {
    return display <= 0.04045 ? display / 12.92 : elementary::pow((display + 0.055) / 1.055, 2.4);
}

double display(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear
                               : 1.055 * elementary::pow(linear, 1.0 / 2.4) - 0.055;
}

std::uint8_t level(double display_share) {
    return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(display_share, 0.0, 1.0)));
}

/// Pixels along each side of a cell, for a background as fine as it is.
int pixels_to_a_cell(const MapPicture& picture, int most) {
    if (!picture.background || picture.blank.empty()) return 1;
    const int longer = std::max(picture.values.nx(), picture.values.ny());
    const int own = std::max(picture.background->width / picture.values.nx(),
                             picture.background->height / picture.values.ny());
    return std::clamp(own, 1, std::max(most / longer, 1));
}

/// What a drape has in a part of its extent, from `low` on, of `count` along a side: the mean.
/// Laid on `under`.
std::array<std::uint8_t, 3> mean_of(const Drape& drape, const std::array<int, 2>& low,
                                    const std::array<int, 2>& count,
                                    const std::array<std::uint8_t, 3>& under) {
    const auto range = [&](std::size_t axis, int side) {
        const auto begin = static_cast<int>(static_cast<long long>(low[axis]) * side / count[axis]);
        const auto end =
            static_cast<int>(static_cast<long long>(low[axis] + 1) * side / count[axis]);
        return std::pair{begin, std::max(end, begin + 1)};
    };
    const auto [west, east] = range(0, drape.width);
    const auto [south, north] = range(1, drape.height);
    std::array<long long, 3> sums{};
    long long all = 0;
    for (int y = south; y < north; ++y) {
        for (int x = west; x < east; ++x) {
            const std::uint8_t* texel =
                drape.texels.data() + 4 * (static_cast<std::ptrdiff_t>(y) * drape.width + x);
            for (std::size_t channel = 0; channel < 3; ++channel)
                sums[channel] += texel[channel] * texel[3] + under[channel] * (255 - texel[3]);
            all += 255;
        }
    }
    std::array<std::uint8_t, 3> mean{};
    for (std::size_t channel = 0; channel < 3; ++channel)
        mean[channel] = static_cast<std::uint8_t>((sums[channel] + all / 2) / all);
    return mean;
}

/// The image of a picture's cells with its background where they are blank.
Image on_background(const Image& cells, const MapPicture& picture, int most,
                    const std::array<std::uint8_t, 3>& empty) {
    const int pixels = pixels_to_a_cell(picture, most);
    Image image(cells.width * pixels, cells.height * pixels);
    for (int row = 0; row < image.height; ++row) {
        const int y = image.height - 1 - row;
        for (int x = 0; x < image.width; ++x) {
            std::uint8_t* pixel = image.row(row) + 3 * static_cast<std::ptrdiff_t>(x);
            if (picture.blank(x / pixels, y / pixels) == 0) {
                std::copy_n(cells.row(row / pixels) + 3 * static_cast<std::ptrdiff_t>(x / pixels),
                            3, pixel);
            } else {
                std::ranges::copy(
                    mean_of(*picture.background, {x, y}, {image.width, image.height}, empty),
                    pixel);
            }
        }
    }
    return image;
}

}  // namespace

std::string field_label(const LookSettings& look, const Snapshot& snapshot,
                        const std::string& called) {
    const SnapshotField& field = coloured_field(look, snapshot);
    std::string name = called.empty() ? field.long_name : called;
    if (called.empty() && look.colour_by == Colouring::field_change)
        name = phrase("change of {}", name);
    const bool has_unit = !field.unit.empty() && field.unit != "1" && field.unit != "-";
    return has_unit ? fmt::format("{} ({})", name, field.unit) : name;
}

const char* usual_palette(Colouring colour_by) {
    return quantity_of(colour_by, {}, {0.0, 1.0}).palette;
}

std::vector<MapPicture> map_pictures(const LookSettings& look, std::span<const Snapshot> snapshots,
                                     const Snapshot& first, const RangeTails& tails) {
    std::vector<Field<float>> coloured;
    coloured.reserve(snapshots.size());
    for (const Snapshot& snapshot : snapshots)
        coloured.push_back(coloured_values(look, snapshot, first));
    const std::pair<double, double> range = joined_colour_range(look, snapshots, coloured, tails);
    std::vector<MapPicture> pictures;
    for (std::size_t k = 0; k < snapshots.size(); ++k) {
        const Snapshot& snapshot = snapshots[k];
        const Field<float> values = std::exchange(coloured[k], {});
        Quantity quantity = quantity_of(look.colour_by, snapshot.scale, range);
        if (quantity.label.empty()) quantity.label = field_label(look, snapshot);
        MapPicture picture;
        picture.values = Grid(values.nx(), values.ny());
        std::transform(values.values().begin(), values.values().end(),
                       picture.values.values().begin(),
                       [&](float value) { return quantity.factor * static_cast<double>(value); });
        picture.blank = uncoloured_cells(look, snapshot, first);
        picture.scale = snapshot.scale;
        picture.colours = {palette_of(look, quantity.palette), quantity.factor * range.first,
                           quantity.factor * range.second, quantity.label};
        pictures.push_back(std::move(picture));
    }
    return pictures;
}

MapPicture map_picture(const LookSettings& look, const Snapshot& snapshot, const Snapshot& first,
                       const RangeTails& tails) {
    return std::move(map_pictures(look, {&snapshot, 1}, first, tails).front());
}

MapPicture field_picture(const LookSettings& look, const Snapshot& snapshot, std::string_view name,
                         const RangeTails& tails) {
    const SnapshotField* field = find_named(snapshot.fields, name);
    if (field == nullptr) throw InputError(fmt::format("the model has no field \"{}\"", name));
    MapPicture picture;
    picture.values = field->values;
    LookSettings by_name = look;
    by_name.colour_by = Colouring::field;
    by_name.field = field->name;
    picture.blank = uncoloured_cells(by_name, snapshot);
    picture.scale = snapshot.scale;
    std::vector<double> known = known_values(picture);
    double low = percentile(known, tails.low);
    double high = percentile(known, 1.0 - tails.high);
    if (!look.low.is_word()) low = look.low.value;
    if (!look.high.is_word()) high = look.high.value;
    if (!(high > low)) high = low + 1.0;
    const std::string what = field->long_name.empty() ? field->name : field->long_name;
    picture.colours = {palette_of(look, "viridis"), low, high,
                       field->unit.empty() || field->unit == "1"
                           ? what
                           : fmt::format("{} ({})", what, field->unit)};
    return picture;
}

std::optional<std::pair<double, double>> values_of(const MapPicture& picture) {
    const std::vector<double> known = known_values(picture);
    if (known.empty()) return std::nullopt;
    const auto [least, greatest] = std::minmax_element(known.begin(), known.end());
    return std::pair{*least, *greatest};
}

Image map_image(const MapPicture& picture, const Ink& blank, int most) {
    const int longer = std::max(picture.values.nx(), picture.values.ny());
    if (longer > most) return map_image(coarser(picture, (longer + most - 1) / most), blank, most);
    Image image(picture.values.nx(), picture.values.ny());
    const std::array<std::uint8_t, 3> empty{level(blank.red), level(blank.green),
                                            level(blank.blue)};
    for (int row = 0; row < image.height; ++row) {
        const int y = image.height - 1 - row;
        std::uint8_t* pixel = image.row(row);
        for (int x = 0; x < image.width; ++x, pixel += 3) {
            const bool known = picture.blank.empty() || picture.blank(x, y) == 0;
            const auto& colour =
                known ? picture.colours.palette[picture.colours.place(picture.values(x, y))]
                      : empty;
            const double light =
                known && !picture.light.empty() ? static_cast<double>(picture.light(x, y)) : 1.0;
            for (std::size_t c = 0; c < 3; ++c)
                pixel[c] =
                    light == 1.0 ? colour[c] : level(display(light * linear(colour[c] / 255.0)));
        }
    }
    const bool shows_background = picture.background && !picture.blank.empty();
    return shows_background ? on_background(image, picture, most, empty) : image;
}

}  // namespace fumon
