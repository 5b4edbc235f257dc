#include <fmt/format.h>

#include "base/error.h"
#include "figure/panels/section_panel.h"
#include "files/csv_table.h"
#include "models/registry.h"
#include "paper/panel_look.h"
#include "paper/panel_makers.h"

namespace fumon {

namespace {

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

/// What a panel of a section shows, as CSV: the nodes with all fields behind a map, the columns
/// with all curves behind lines, the points of paths.
std::string section_csv(const SnapshotSection& section, SectionPanel panel) {
    if (panel == SectionPanel::paths) return path_csv(section);
    const bool map = panel == SectionPanel::velocity || panel == SectionPanel::pressure;
    return map ? node_csv(section) : line_csv(section);
}

void check_section(const PanelSettings& settings, const Scene& scene, const Snapshot& first) {
    if (!first.section) {
        throw KeyError("kind", fmt::format("a section needs a model with one ({}), not {}; heights "
                                           "along a row are a profile",
                                           models_of(Landform::air), scene.model.name));
    }
    SectionSettings wanted;
    wanted.panels = {settings.section};
    try {
        section_panels(wanted, first);
    } catch (const InputError& fault) {
        throw KeyError("section", fault.what());
    }
}

std::vector<MadePanel> make_sections(const PanelSubject& subject, PanelTools& /*tools*/) {
    const PanelSettings& settings = subject.panel.settings;
    const Scene& scene = subject.panel.picture->scene;
    View view = scene.view;
    view.look = look_of(settings, scene);
    view.section.panels = {settings.section};
    if (!settings.low.is_word()) view.section.low = settings.low;
    if (!settings.high.is_word()) view.section.high = settings.high;
    std::vector<MadePanel> made;
    for (const Snapshot& snapshot : subject.snapshots) {
        const SectionPanel shown = section_panels(view.section, snapshot).front();
        MadePanel one;
        if (shown == SectionPanel::velocity || shown == SectionPanel::pressure)
            one.remarks.push_back(range_sentence(section_colours(view, snapshot, shown), {}));
        one.data = {{".csv", section_csv(*snapshot.section, shown)}};
        one.content = make_section_panel(
            view, snapshot, shown, settings.colour_bar ? BarPosition::right : BarPosition::none);
        made.push_back(std::move(one));
    }
    return made;
}

}  // namespace

const PanelMaker panels::section{check_section, make_sections};

}  // namespace fumon
