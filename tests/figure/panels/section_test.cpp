#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.h"
#include "figure/panels/colour_bar.h"
#include "figure/panels/section_figure.h"
#include "figure/panels/section_map.h"
#include "support/section_beds.h"

namespace fumon {
namespace {

/// The section of eddies with pressure, stress and flights, `height` high for a length of 1.
Snapshot full_section(int nx, int nz) {
    Snapshot snapshot = eddy_section(nx, nz);
    auto section = std::make_shared<SnapshotSection>(*snapshot.section);
    section->fields.push_back({"pressure", "", "Pa", section->fields[1].values});
    section->curves.push_back({"bed_shear_stress", "", "Pa", {}});
    section->curves.push_back({"flight_length_10", "", "m", {}});
    section->curves.push_back({"flight_length_40", "", "m", {}});
    for (int i = 0; i < nx; ++i) {
        section->curves[0].values.push_back(-0.004 + 1e-4 * i);
        section->curves[1].values.push_back(1e-3 * i);
        section->curves[2].values.push_back(2e-3 * i);
    }
    section->paths[1].launch_angle = 40.0;
    snapshot.section = section;
    return snapshot;
}

/// The same with dz chosen so that the section is `aspect` as high as long.
Snapshot section_of_aspect(double aspect) {
    Snapshot snapshot = full_section(48, 32);
    auto section = std::make_shared<SnapshotSection>(*snapshot.section);
    section->dz = aspect / 31.0;
    snapshot.section = section;
    return snapshot;
}

View figure_view(int width, int height) {
    View view;
    view.look.mode = ViewMode::figure;
    view.image.width = width;
    view.image.height = height;
    return view;
}

TEST(SectionFigure, CutsNoTextAndLaysNoneOverAnother) {
    for (const double aspect : {0.3, 0.117, 1.0}) {  // as Terada 2025's tables 2 and 3, and higher
        const Snapshot snapshot = section_of_aspect(aspect);
        for (const auto& [width, height] : {std::pair{320, 240}, {480, 800}, {1280, 720}}) {
            for (const bool all : {false, true}) {
                View view = figure_view(width, height);
                if (all) {
                    view.section.panels = {"velocity", "pressure",   "stress",
                                           "flights",  "flight-law", "paths"};
                }
                const auto texts = draw_section_figure(view, snapshot).texts;
                ASSERT_GT(texts.size(), 20U);
                const double slack = 0.5;  // pixels
                for (std::size_t i = 0; i < texts.size(); ++i) {
                    const CanvasBox& box = texts[i].box;
                    EXPECT_TRUE(box.x >= 0.0 && box.y >= 0.0 && box.x + box.width <= width &&
                                box.y + box.height <= height)
                        << texts[i].text << " in " << width << " x " << height << ", " << aspect;
                    for (std::size_t j = 0; j < i; ++j) {
                        EXPECT_FALSE(overlap(box, texts[j].box, slack))
                            << texts[i].text << " over " << texts[j].text << " in " << width
                            << " x " << height << ", " << aspect;
                    }
                }
            }
        }
    }
}

TEST(SectionFigure, ColoursAPixelByItsValue) {
    Snapshot snapshot = full_section(48, 32);
    auto section = std::make_shared<SnapshotSection>(*snapshot.section);
    for (SnapshotField& field : section->fields) {
        for (double& value : field.values.values()) value = field.name == "velocity_x" ? 2.0 : 0.0;
    }
    snapshot.section = section;
    View view = figure_view(400, 300);
    view.section.panels = {"velocity"};
    view.section.arrows = SectionArrows::none;
    view.section.low = {"", 0.0};
    view.section.high = {"", 5.0};
    view.look.palette = "cividis";
    const SectionFigure figure = draw_section_figure(view, snapshot);
    const CanvasBox frame = figure.frames.front();
    const auto expected = read_palette("cividis")[102];  // 2 / 5 of 255
    const std::uint8_t* at = figure.image.row(static_cast<int>(frame.y + 0.25 * frame.height)) +
                             3 * static_cast<int>(frame.x + 0.5 * frame.width);
    EXPECT_EQ((std::array<int, 3>{at[0], at[1], at[2]}),
              (std::array<int, 3>{expected[0], expected[1], expected[2]}));
}

TEST(SectionFigure, KeepsEqualScalesOrSaysByHowMuchNot) {
    View view = figure_view(800, 600);
    view.section.panels = {"velocity"};
    const SectionFigure equal = draw_section_figure(view, section_of_aspect(0.6));
    EXPECT_EQ(equal.exaggeration, 1.0);
    EXPECT_NEAR(equal.frames[0].height / equal.frames[0].width, 0.6, 0.01);
    const SectionFigure flat = draw_section_figure(view, section_of_aspect(0.05));
    EXPECT_GT(flat.exaggeration, 1.0);
    EXPECT_NEAR(flat.frames[0].height / flat.frames[0].width, 0.05 * flat.exaggeration, 0.01);
    EXPECT_TRUE(std::any_of(flat.texts.begin(), flat.texts.end(), [](const PlacedText& text) {
        return text.text.find("heights × ") != std::string::npos;
    }));
}

TEST(SectionFigure, SaysWhereValuesLieBeyondALimit) {
    const Snapshot snapshot = full_section(48, 32);
    View view;
    const ColourScale whole = section_colours(view, snapshot, SectionPanel::velocity);
    EXPECT_FALSE(whole.values_above);
    EXPECT_FALSE(whole.values_below);
    view.section.high = 0.5 * whole.high;
    EXPECT_TRUE(section_colours(view, snapshot, SectionPanel::velocity).values_above);
    EXPECT_FALSE(section_colours(view, snapshot, SectionPanel::pressure).values_above);
}

TEST(SectionFigure, DrawsTheSamePixelsAgain) {
    View view = figure_view(400, 300);
    const Snapshot snapshot = full_section(48, 32);
    const Image arrows = draw_section_figure(view, snapshot).image;
    EXPECT_EQ(arrows, draw_section_figure(view, snapshot).image);
    view.section.arrows = SectionArrows::streamlines;
    EXPECT_NE(arrows, draw_section_figure(view, snapshot).image);
}

TEST(SectionFigure, RefusesPanelsThatItCannotDraw) {
    SectionSettings settings;
    EXPECT_EQ(section_panels(settings, full_section(24, 16)).size(), 3U);
    EXPECT_EQ(section_panels(settings, eddy_section(24, 16)).size(), 1U);
    settings.panels = {"vorticty"};
    EXPECT_THROW(section_panels(settings, full_section(24, 16)), KeyError);
    settings.panels = {"flights"};
    EXPECT_EQ(section_panels(settings, full_section(24, 16)).size(), 1U);
    EXPECT_THROW(section_panels(settings, eddy_section(24, 16)), KeyError);
    View view = figure_view(320, 240);
    view.section.font_size = {"", 100.0};
    EXPECT_THROW(draw_section_figure(view, full_section(24, 16)), KeyError);
}

}  // namespace
}  // namespace fumon
