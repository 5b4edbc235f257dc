#include "figure/panels/time_space_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "base/error.h"
#include "base/quantity_text.h"
#include "figure/panels/axis_units.h"
#include "figure/panels/map_picture.h"
#include "figure/panels/row_means.h"
#include "figure/words/words.h"

namespace fumon {

namespace {

constexpr int most_pixel_rows = 2100;  // of pixels
constexpr std::uint8_t blank = 255;    // white, where there is no value

/// Pixels of even time, the latest at the top: each is the record that is nearest in time.
Image image_of(const TimeSpacePicture& picture) {
    const int records = picture.values.ny();
    const double first = picture.times.front();
    const double last = picture.times.back();
    double shortest = last - first;
    for (std::size_t n = 1; n < picture.times.size(); ++n)
        shortest = std::min(shortest, picture.times[n] - picture.times[n - 1]);
    const double even = (last - first) / std::max(shortest, 1e-12);
    Image image(picture.values.nx(), static_cast<int>(std::clamp(
                                         2.0 * even, 1.0, static_cast<double>(most_pixel_rows))));
    int record = 0;
    for (int row = image.height - 1; row >= 0; --row) {
        const double share = (image.height - 0.5 - row) / image.height;
        const double time = first + share * (last - first);
        const auto after = [&](int n) { return picture.times[static_cast<std::size_t>(n)]; };
        while (record + 1 < records && after(record + 1) - time <= time - after(record)) ++record;
        std::uint8_t* pixel = image.row(row);
        for (int x = 0; x < image.width; ++x, pixel += 3) {
            const double value = picture.values(x, record);
            if (std::isnan(value)) {
                std::fill_n(pixel, 3, blank);
                continue;
            }
            const auto& colour = picture.colours.palette[picture.colours.place(value)];
            std::copy(colour.begin(), colour.end(), pixel);
        }
    }
    return image;
}

}  // namespace

TimeSpacePicture time_space_picture(const LookSettings& look, std::span<const Snapshot> snapshots,
                                    std::optional<int> row, const RangeTails& tails) {
    if (snapshots.size() < 2) throw InputError("a time-space picture needs two records or more");
    const int ny = snapshots.front().bed.ny();
    if (row && (*row < 0 || *row >= ny))
        throw InputError(
            fmt::format("row {} of a time-space picture: the bed has rows 0 to {}", *row, ny - 1));
    const auto maps = map_pictures(look, snapshots, snapshots.front(), tails);
    const int nx = maps.front().values.nx();
    TimeSpacePicture picture;
    picture.values = Grid(nx, static_cast<int>(maps.size()));
    picture.colours = maps.front().colours;
    picture.length = bed_extent(maps.front().values, maps.front().scale).width;
    picture.in_metres = maps.front().scale.in_metres;
    const std::string& unit = snapshots.front().time_unit;
    picture.time_label = unit == "steps" ? word("step") : labelled("t", unit);
    for (std::size_t n = 0; n < maps.size(); ++n) {
        picture.times.push_back(snapshots[n].time);
        const std::vector<double> means =
            row_means(maps[n].values, maps[n].blank, row.value_or(0), row.value_or(ny - 1));
        std::copy(means.begin(), means.end(), picture.values.row(static_cast<int>(n)).begin());
    }
    return picture;
}

TimeSpacePanel::TimeSpacePanel(TimeSpacePicture picture, BarPosition colour_bar)
    : picture_(std::move(picture)), colour_bar_(colour_bar) {}

Axes TimeSpacePanel::axes_in(const CanvasBox& frame) const {
    const LengthUnit unit = length_unit(picture_.in_metres, picture_.length);
    return {frame,
            {0.0, picture_.length / unit.length,
             label_or(picture_.x_label, labelled("x", unit.symbol))},
            {picture_.times.front(), picture_.times.back(),
             label_or(picture_.y_label, picture_.time_label)}};
}

PanelMargins TimeSpacePanel::margins(const Canvas& canvas, double width, double height) const {
    return with_colour_bar(canvas, axes_in({0.0, 0.0, width, height}).margins(canvas), colour_bar_,
                           picture_.colours, width, height);
}

void TimeSpacePanel::draw(Canvas& canvas, const CanvasBox& frame) const {
    canvas.draw(image_of(picture_), frame);
    const Axes axes = axes_in(frame);
    axes.draw(canvas);
    draw_placed_bar(canvas, frame, axes.margins(canvas), colour_bar_, picture_.colours);
}

}  // namespace fumon
