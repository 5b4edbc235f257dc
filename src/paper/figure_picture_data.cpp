#include "paper/figure_picture_data.h"

#include <fmt/format.h>

#include "files/csv_table.h"

namespace fumon {

namespace {

const char* x_column(bool in_metres) {
    return in_metres ? "x (m)" : "x (sites)";
}

std::string node_csv(const SnapshotSection& section) {
    std::vector<std::string> header{"x (m)", "z (m)"};
    for (const SnapshotField& field : section.fields)
        header.push_back(fmt::format("{} ({})", field.name, field.unit));
    std::string text = csv_line(header);
    const Grid& first = section.fields.front().values;
    for (int k = 0; k < first.ny(); ++k) {
        for (int i = 0; i < first.nx(); ++i) {
            text += fmt::format("{},{}", i * section.dx, k * section.dz);
            for (const SnapshotField& field : section.fields)
                text += fmt::format(",{}", field.values(i, k));
            text += '\n';
        }
    }
    return text;
}

std::string line_csv(const SnapshotSection& section) {
    std::vector<std::string> header{"x (m)"};
    for (const SectionCurve& curve : section.curves)
        header.push_back(fmt::format("{} ({})", curve.name, curve.unit));
    std::string text = csv_line(header);
    const std::size_t columns = section.curves.front().values.size();
    for (std::size_t i = 0; i < columns; ++i) {
        text += fmt::format("{}", static_cast<double>(i) * section.dx);
        for (const SectionCurve& curve : section.curves)
            text += fmt::format(",{}", curve.values[i]);
        text += '\n';
    }
    return text;
}

std::string path_csv(const SnapshotSection& section) {
    std::string text = csv_line({"path", "launch_angle (degrees)", "x (m)", "z (m)"});
    for (std::size_t path = 0; path < section.paths.size(); ++path) {
        const GrainPath& grain = section.paths[path];
        for (std::size_t i = 0; i < grain.x.size(); ++i) {
            text +=
                fmt::format("{},{},{},{}\n", path + 1, grain.launch_angle, grain.x[i], grain.z[i]);
        }
    }
    return text;
}

}  // namespace

std::string section_csv(const SnapshotSection& section, SectionPanel panel) {
    if (panel == SectionPanel::paths) return path_csv(section);
    const bool map = panel == SectionPanel::velocity || panel == SectionPanel::pressure;
    return map ? node_csv(section) : line_csv(section);
}

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
