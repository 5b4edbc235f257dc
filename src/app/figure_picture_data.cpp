#include "app/figure_picture_data.h"

#include <fmt/format.h>

#include "files/csv_table.h"

namespace fumon {

namespace {

const char* x_column(bool in_metres) {
    return in_metres ? "x (m)" : "x (sites)";
}

}  // namespace

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
            row.push_back(fmt::format("{}", line.bed[i]));
            if (!line.surface.empty()) row.push_back(fmt::format("{}", line.surface[i]));
        }
        text += csv_line(row);
    }
    return text;
}

std::string time_space_csv(const TimeSpacePicture& picture) {
    std::string text =
        csv_line({picture.time_label, x_column(picture.in_metres), picture.colours.label});
    const int cells = picture.values.nx();
    for (int n = 0; n < picture.values.ny(); ++n) {
        for (int i = 0; i < cells; ++i) {
            text += fmt::format("{},{},{}\n", picture.times[static_cast<std::size_t>(n)],
                                picture.length * (i + 0.5) / cells, picture.values(i, n));
        }
    }
    return text;
}

}  // namespace fumon
