#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/snapshot.h"
#include "figure/canvas/panel.h"
#include "figure/panels/colour_bar.h"
#include "scene/scene.h"

namespace fumon {

enum class SectionPanel { velocity, pressure, stress, flights, flight_law, paths };

/// The panels of a snapshot's section that the settings ask for. Throws KeyError("section.panels")
/// for one that there is none of, or that the section does not give.
std::vector<SectionPanel> section_panels(const SectionSettings& settings, const Snapshot& snapshot);

/// What a panel shows, in a few words.
std::string section_title(SectionPanel panel);

/// The vertical exaggeration of a section's maps: 1, or for one more than six times as long as high
/// the largest of 2, 5, 10 … that leaves it at least three times as long.
double section_exaggeration(const Snapshot& snapshot);

/// The colours of a map of a snapshot's section: of its velocity or pressure.
ColourScale section_colours(const View& view, const Snapshot& snapshot, SectionPanel panel);

/// One panel of a snapshot's section, which has what the panel shows. Maps (velocity, pressure)
/// keep their scales equal, or exaggerated as section_exaggeration() says and they state above;
/// their range and arrows are those of view.section. Throws InputError where there is no such
/// palette.
std::unique_ptr<PanelContent> make_section_panel(const View& view, const Snapshot& snapshot,
                                                 SectionPanel panel,
                                                 BarPosition colour_bar = BarPosition::right);

}  // namespace fumon
