#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/quantity_text.h"
#include "figure/panels/time_space_panel.h"
#include "files/csv_table.h"
#include "paper/panel_look.h"
#include "paper/panel_makers.h"

namespace fumon {

namespace {

/// A time–space diagram as CSV: one row per time and place.
std::string time_space_csv(const TimeSpacePicture& picture) {
    std::string text =
        csv_line({picture.time_label, x_column(picture.in_metres), picture.colours.label});
    const int cells = picture.values.nx();
    for (int n = 0; n < picture.values.ny(); ++n) {
        for (int i = 0; i < cells; ++i) {
            text +=
                fmt::format("{},{},{}\n", picture.times[static_cast<std::size_t>(n)],
                            picture.length * (i + 0.5) / cells, csv_number(picture.values(i, n)));
        }
    }
    return text;
}

/// The least and the greatest value but for those that are not known; 0 and 0 where none is.
std::pair<double, double> range_of_known(const Grid& values) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const double value : values.values()) {
        if (std::isnan(value)) continue;
        low = std::min(low, value);
        high = std::max(high, value);
    }
    return low <= high ? std::pair{low, high} : std::pair{0.0, 0.0};
}

std::vector<MadePanel> make_time_space(const PanelSubject& subject, PanelTools& /*tools*/) {
    const PanelSettings& settings = subject.panel.settings;
    LookSettings look = look_of(settings, subject.panel.picture->scene);
    look.colour_by = colouring_of(settings.field).value_or(Colouring::height);
    TimeSpacePicture picture =
        time_space_picture(look, subject.snapshots, row_of(settings, subject.snapshots.front().bed),
                           tails_of(settings));
    const std::pair shown = range_of_known(picture.values);
    const double farthest = std::max(std::abs(shown.first), std::abs(shown.second));
    const bool balanced = look.colour_by == Colouring::change;
    if (settings.low.word == "auto" && look.low.is_word())
        picture.colours.low = balanced ? -farthest : shown.first;
    if (settings.high.word == "auto" && look.high.is_word())
        picture.colours.high = balanced ? farthest : shown.second;
    if (!(picture.colours.high > picture.colours.low))
        picture.colours.high = picture.colours.low + 1.0;
    if (labels_range_ends(settings)) mark_range_ends(picture.colours, shown);
    std::vector<MadePanel> made(1);
    made[0].remarks.push_back(range_sentence(picture.colours, shown));
    made[0].data = {{".csv", time_space_csv(picture)}};
    picture.x_label = settings.x_label;
    picture.y_label = settings.y_label;
    picture.colours.label = label_or(settings.bar_label, picture.colours.label);
    made[0].content = std::make_unique<TimeSpacePanel>(
        std::move(picture), settings.colour_bar ? BarPosition::right : BarPosition::none);
    return made;
}

}  // namespace

const PanelMaker panels::time_space{nullptr, make_time_space};

}  // namespace fumon
