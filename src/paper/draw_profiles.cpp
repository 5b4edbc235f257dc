#include <fmt/format.h>

#include "figure/panels/profile_panel.h"
#include "files/csv_table.h"
#include "paper/panel_look.h"
#include "paper/panel_makers.h"

namespace fumon {

namespace {

/// Profiles as CSV: x, then a column for each bed and each water surface.
std::string profile_csv(const ProfilePicture& picture) {
    std::vector<std::string> header{x_column(picture.in_metres)};
    for (const ProfileLine& line : picture.lines) {
        header.push_back("bed, " + line.label);
        if (!line.surface.empty()) header.push_back("water, " + line.label);
    }
    std::string text = csv_line(header);
    const std::size_t cells = picture.lines.front().bed.size();
    for (std::size_t i = 0; i < cells; ++i) {
        const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(cells);
        std::vector<std::string> row{fmt::format("{}", picture.length * share)};
        for (const ProfileLine& line : picture.lines) {
            row.push_back(csv_number(line.bed[i]));
            if (!line.surface.empty()) row.push_back(csv_number(line.surface[i]));
        }
        text += csv_line(row);
    }
    return text;
}

std::vector<MadePanel> make_profiles(const PanelSubject& subject, PanelTools& /*tools*/) {
    const PanelSettings& settings = subject.panel.settings;
    ProfilePicture picture =
        profile_picture(subject.snapshots, row_of(settings, subject.snapshots.front().bed));
    picture.x_label = settings.x_label;
    picture.y_label = settings.y_label;
    if (settings.arrow == PanelArrow::wind) picture.wind = wind_direction(subject.first);
    std::vector<MadePanel> made(1);
    made[0].data = {{".csv", profile_csv(picture)}};
    made[0].content = std::make_unique<ProfilePanel>(std::move(picture));
    return made;
}

}  // namespace

const PanelMaker panels::profile{nullptr, make_profiles};

}  // namespace fumon
