#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "base/error.h"
#include "base/worker_pool.h"
#include "figure/panels/hill_shading.h"
#include "figure/panels/map_panel.h"
#include "figure/panels/profile_panel.h"
#include "figure/panels/section_panel.h"
#include "figure/panels/time_space_panel.h"
#include "figure/panels/view_panel.h"
#include "support/picture_pixels.h"
#include "support/section_beds.h"
#include "support/water_beds.h"

namespace fumon {
namespace {

using test::at_step;
using test::Pixel;
using test::pixel_at;

Pixel colour_of(const ColourScale& scale, double value) {
    const auto& colour = scale.palette[scale.place(value)];
    return {colour[0], colour[1], colour[2]};
}

int difference(const Pixel& a, const Pixel& b) {
    int most = 0;
    for (std::size_t c = 0; c < 3; ++c) most = std::max(most, std::abs(a[c] - b[c]));
    return most;
}

LookSettings heights() {
    LookSettings look;
    look.colour_by = Colouring::height;
    return look;
}

/// Beds of a ridge that moves by a cell a step.
std::vector<Snapshot> moving_ridge(const std::vector<int>& steps) {
    std::vector<Snapshot> snapshots;
    for (const int step : steps) {
        Snapshot snapshot;
        snapshot.bed = Grid(20, 4, 0.0);
        for (int y = 0; y < 4; ++y) snapshot.bed(step % 20, y) = 1.0 + y;
        snapshots.push_back(at_step(snapshot, step));
    }
    return snapshots;
}

/// The renderer's place is taken by an even block on white, which only the cut depends on.
ViewPicture block_picture(double azimuth) {
    View view;
    view.camera.azimuth = azimuth;
    Snapshot first = wavy_bed(30, 20);
    first.scale = {0.5, 0.5, 1.0, true};
    const ViewProjection projection{place_camera(view.camera, frame_block(first, 3.0), 1.5, 0.0),
                                    frame_block(first, 3.0),
                                    {0.0, 0.0, 600.0, 400.0}};
    Image image(600, 400);
    std::fill(image.rgb.begin(), image.rgb.end(), std::uint8_t{255});
    for (int i = 0; i <= 300; ++i) {
        for (int k = 0; k <= 300; ++k) {
            const CanvasPoint at =
                projection.at_ground({15.0 * i / 300, 10.0 * k / 300}, projection.block.base);
            image.row(static_cast<int>(at.y))[3 * static_cast<int>(at.x) + 1] = 100;
        }
    }
    return view_picture(view, image, first, 3.0);
}

TEST(MapPanel, ShowsEveryCellInTheBarsColourWithNorthUp) {
    Snapshot snapshot = wavy_bed(12, 7);
    snapshot.scale = {2.0, 3.0, 1.0, true};  // cells that are no squares
    snapshot.nodata = Mask(12, 7);
    snapshot.nodata(3, 1) = 1;
    const MapPicture picture = map_picture(heights(), snapshot, snapshot);
    MapPanelSettings settings;
    settings.blank = {1.0, 0.0, 1.0, 1.0};
    const MapPanel panel(picture, settings);
    EXPECT_NEAR(panel.aspect(), 24.0 / 21.0, 1e-12);
    Canvas canvas(500, 400, 12.0);
    const CanvasBox frame{80.0, 40.0, 240.0, 210.0};
    panel.draw(canvas, frame);
    const Image image = canvas.image();
    for (int y = 0; y < 7; ++y) {
        for (int x = 0; x < 12; ++x) {
            const Pixel seen = pixel_at(image, 80.0 + 20.0 * (x + 0.5), 250.0 - 30.0 * (y + 0.5));
            const bool blank = x == 3 && y == 1;
            EXPECT_LE(difference(seen, blank ? Pixel{255, 0, 255}
                                             : colour_of(picture.colours, snapshot.bed(x, y))),
                      1)
                << x << ", " << y;
        }
    }
}

TEST(MapPanel, LabelsHeightsByTheirUnit) {
    Snapshot snapshot = wavy_bed(12, 7);
    EXPECT_EQ(map_picture(heights(), snapshot, snapshot).colours.label, "height (model heights)");
    snapshot.scale = {1e-3, 1e-3, 1e-4, true};
    const MapPicture millimetres = map_picture(heights(), snapshot, snapshot);
    EXPECT_EQ(millimetres.colours.label, "height (mm)");
    EXPECT_NEAR(millimetres.values(5, 3), 0.1 * snapshot.bed(5, 3), 1e-6);
    snapshot.scale = {1.0, 1.0, 10.0, true};
    EXPECT_EQ(map_picture(heights(), snapshot, snapshot).colours.label, "height (m)");
    EXPECT_THROW(field_picture(heights(), snapshot, "moisture"), InputError);
}

TEST(MapPanel, SharesOneRangeAmongPictures) {
    Snapshot low = wavy_bed(12, 7);
    Snapshot high = low;
    for (double& height : high.bed.values()) height += 5.0;
    const auto pictures = map_pictures(heights(), std::array{low, high}, low);
    EXPECT_EQ(pictures[0].colours.low, pictures[1].colours.low);
    EXPECT_EQ(pictures[0].colours.high, pictures[1].colours.high);
    EXPECT_EQ(pictures[0].colours.low, map_picture(heights(), low, low).colours.low);
    EXPECT_EQ(pictures[0].colours.high, map_picture(heights(), high, low).colours.high);
}

TEST(MapPanel, AveragesCellsThatAreTooMany) {
    MapPicture picture;
    picture.values = Grid(10, 6);
    picture.blank = Mask(10, 6);
    for (int y = 0; y < 6; ++y) {
        for (int x = 0; x < 10; ++x) picture.values(x, y) = x / 2 + 10.0 * (y / 2) + (x % 2 - 0.5);
    }
    for (int y = 0; y < 2; ++y) picture.blank(0, y) = picture.blank(1, y) = 1;
    picture.colours = {read_palette("viridis"), 0.0, 25.0, ""};
    const Image image = map_image(picture, {}, 5);
    ASSERT_EQ(image.width, 5);
    ASSERT_EQ(image.height, 3);
    EXPECT_EQ(pixel_at(image, 0, 2), (Pixel{0, 0, 0}));  // all of its cells are blank
    EXPECT_EQ(pixel_at(image, 3, 2), colour_of(picture.colours, 3.0));
    EXPECT_EQ(pixel_at(image, 2, 0), colour_of(picture.colours, 22.0));
}

TEST(MapPanel, ShowsABackgroundWhereCellsHaveNoValue) {
    MapPicture picture;
    picture.values = Grid(3, 2, 0.7);
    picture.blank = Mask(3, 2);
    picture.blank(2, 0) = 1;
    picture.colours = {read_palette("batlow"), 0.0, 1.0, ""};
    Drape drape{12, 8, {}};
    for (int y = 0; y < drape.height; ++y) {
        for (int x = 0; x < drape.width; ++x) {
            const auto east = static_cast<std::uint8_t>(20 * x);
            const auto north = static_cast<std::uint8_t>(30 * y);
            drape.texels.insert(drape.texels.end(), {east, north, 9, 255});
        }
    }
    picture.background = std::make_shared<const Drape>(drape);
    const Image image = map_image(picture, {}, 100);
    ASSERT_EQ(image.width, 12);
    ASSERT_EQ(image.height, 8);
    EXPECT_EQ(pixel_at(image, 7, 7), colour_of(picture.colours, 0.7));
    EXPECT_EQ(pixel_at(image, 8, 7), (Pixel{160, 0, 9}));  // the blank cell's south-western pixel
    EXPECT_EQ(pixel_at(image, 11, 4), (Pixel{220, 90, 9}));
    EXPECT_EQ(pixel_at(image, 11, 3), colour_of(picture.colours, 0.7));
    const Image coarse = map_image(picture, {}, 6);  // means of four
    ASSERT_EQ(coarse.width, 6);
    EXPECT_EQ(pixel_at(coarse, 4, 3), (Pixel{170, 15, 9}));
}

/// A line from corner to corner of a map, whose pixels lie where it lies; its legend keeps off the
/// cells with values.
TEST(MapPanel, ShowsLayersAndTheirLegend) {
    MapPicture picture;
    picture.values = Grid(60, 40, 0.5);
    picture.blank = Mask(60, 40, 0);
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 30; ++x) picture.blank(x, y) = 1;  // in the south-west
    picture.colours = {read_palette("grey"), 0.0, 1.0, ""};
    EXPECT_EQ(emptiest_corner(picture, {0.0, 0.0, 600.0, 400.0}, {150.0, 40.0}, 10.0, {}),
              Corner::lower_left);
    EXPECT_EQ(emptiest_corner(picture, {0.0, 0.0, 600.0, 400.0}, {150.0, 40.0}, 10.0,
                              {Corner::lower_left, Corner::upper_right}),
              Corner::lower_right);
    PlacedLayers placed;
    placed.layers.resize(1);
    LayerFeature area;
    area.shape = LayerShape::areas;
    area.rings = {{{0.6, 0.6}, {0.8, 0.6}, {0.8, 0.8}, {0.6, 0.8}}};
    LayerFeature line;
    line.lines = {{{0.5, 0.0}, {0.5, 1.0}}};
    placed.layers[0].features = {area, line};
    MapPanelSettings settings;
    settings.axes = false;
    settings.colour_bar = BarPosition::none;
    settings.layers.resize(1);
    settings.layers[0].colour = "#ff0000";
    settings.layers[0].fill_opacity = 1.0;
    settings.layers[0].width = 4.0;
    settings.placed_layers = std::make_shared<const PlacedLayers>(placed);
    Canvas canvas(600, 400, 12.0);
    MapPanel(picture, settings).draw(canvas, {0.0, 0.0, 600.0, 400.0});
    const Image image = canvas.image();
    const Pixel red{255, 0, 0};
    EXPECT_EQ(pixel_at(image, 300, 200), red);
    EXPECT_EQ(pixel_at(image, 299, 30), red);
    EXPECT_NE(pixel_at(image, 305, 200), red);
    EXPECT_EQ(pixel_at(image, 420, 120), red);  // within the area, north up
    EXPECT_NE(pixel_at(image, 420, 280), red);
}

TEST(HillLight, DarkensSlopesThatTurnAwayFromTheSunAndNoLevelGround) {
    WorkerPool pool(2);
    Snapshot snapshot;
    snapshot.bed = Grid(64, 8, 0.0);
    for (int y = 0; y < 8; ++y) {
        for (int x = 24; x < 40; ++x) snapshot.bed(x, y) = 4.0 - 0.5 * std::abs(x - 32);
    }
    for (const bool all : {false, true}) {
        HillShading shading;
        shading.sun.azimuth = 270.0;  // in the west
        shading.from_all_sides = all;
        const Field<float> light = hill_light(snapshot, shading, pool);
        EXPECT_NEAR(light(4, 4), 1.0, 0.02);
        EXPECT_LT(light(36, 4), 0.9 * light(28, 4));
        shading.strength = 0.0;
        EXPECT_EQ(hill_light(snapshot, shading, pool)(36, 4), 1.0F);
    }
}

TEST(HillLight, MultipliesLuminanceOnly) {
    MapPicture picture;
    picture.values = Grid(1, 1, 0.7);
    picture.light = Field<float>(1, 1, 0.5F);
    picture.colours = {read_palette("batlow"), 0.0, 1.0, ""};
    const Pixel shaded = pixel_at(map_image(picture, {}, 10), 0, 0);
    const Pixel plain = colour_of(picture.colours, 0.7);
    const auto linear = [](int level) {  // IEC 61966-2-1
        const double display = level / 255.0;
        return display <= 0.04045 ? display / 12.92 : std::pow((display + 0.055) / 1.055, 2.4);
    };
    for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(linear(shaded[c]), 0.5 * linear(plain[c]), 0.005);
    }
}

TEST(TimeSpacePanel, HasTimeUpwardAndEachRecordAroundItsTime) {
    const auto snapshots = moving_ridge({0, 2, 10});
    const TimeSpacePicture picture = time_space_picture(heights(), snapshots, 1);
    EXPECT_EQ(picture.values(2, 1), 2.0);
    EXPECT_EQ(time_space_picture(heights(), snapshots, std::nullopt).values(2, 1), 2.5);
    EXPECT_THROW(time_space_picture(heights(), snapshots, 4), InputError);
    EXPECT_THROW(time_space_picture(heights(), {snapshots.data(), 1}, 1), InputError);
    Canvas canvas(400, 300, 10.0);
    const CanvasBox frame{60.0, 20.0, 200.0, 200.0};
    TimeSpacePanel(picture).draw(canvas, frame);
    const Image image = canvas.image();
    for (const auto& [time, record] : {std::pair{0.5, 0}, {1.5, 1}, {5.5, 1}, {6.5, 2}, {9.5, 2}}) {
        for (int x = 0; x < 20; ++x) {
            EXPECT_LE(difference(pixel_at(image, 60.0 + 10.0 * (x + 0.5), 220.0 - 20.0 * time),
                                 colour_of(picture.colours, picture.values(x, record))),
                      1)
                << x << " at " << time;
        }
    }
}

TEST(TimeSpacePanel, LeavesCellsWithoutDataWhite) {
    auto snapshots = moving_ridge({0, 2});
    for (Snapshot& snapshot : snapshots) {
        snapshot.nodata = Mask(20, 4, 0);
        for (int y = 0; y < 4; ++y) snapshot.nodata(7, y) = 1;
        snapshot.nodata(2, 3) = 1;
    }
    const TimeSpacePicture picture = time_space_picture(heights(), snapshots, std::nullopt);
    EXPECT_TRUE(std::isnan(picture.values(7, 0)));
    EXPECT_EQ(picture.values(2, 1), 2.0) << "the mean of three rows";
    Canvas canvas(400, 300, 10.0);
    TimeSpacePanel(picture).draw(canvas, {60.0, 20.0, 200.0, 200.0});
    const Image image = canvas.image();
    EXPECT_EQ(difference(pixel_at(image, 60.0 + 75.0, 120.0), {255, 255, 255}), 0);
    EXPECT_GT(difference(pixel_at(image, 60.0 + 85.0, 120.0), {255, 255, 255}), 9);
}

TEST(ViewPanel, LaysItsBarBesideTheEdgeThatFacesTheCamera) {
    const CanvasBox frame{0.0, 0.0, 300.0, 200.0};
    // The edges along x are 15 m long, those along y 10 m.
    for (const auto& [azimuth, text] :
         {std::pair{180.0, "5 m"}, {215.0, "5 m"}, {0.0, "5 m"}, {100.0, "2 m"}}) {
        const ViewPicture picture = block_picture(azimuth);
        EXPECT_LT(picture.image.width, 600);  // cut
        const ViewProjection view = picture.in(frame);
        const GroundBar bar = ViewPanel(picture, {}).ground_bar(frame);
        EXPECT_EQ(bar.text, text) << azimuth;
        // Lower on the canvas than the block's middle, and beyond the block.
        const CanvasPoint middle = view.at_ground({7.5, 5.0}, picture.block.base);
        EXPECT_GT(bar.from.y, middle.y) << azimuth;
        // The cut picture's corners are those of the whole.
        EXPECT_NEAR(view.picture.width / frame.width, 600.0 / picture.image.width, 1e-9);
    }
}

TEST(ViewPanel, LaysItsBarBesideTheGroundThatIsThere) {
    const CanvasBox frame{0.0, 0.0, 300.0, 200.0};
    ViewPicture picture = block_picture(180.0);
    const GroundBar whole = ViewPanel(picture, {}).ground_bar(frame);
    const auto corner = [&](double x, double y) {
        const Block& block = picture.block;
        return glm::dvec2(x / block.side - 0.5 * block.width_x,
                          y / block.side - 0.5 * block.width_y);
    };
    picture.block.outline = {corner(3.0, 4.0), corner(6.0, 4.0), corner(3.0, 6.0),
                             corner(6.0, 6.0)};
    const GroundBar bar = ViewPanel(picture, {}).ground_bar(frame);
    EXPECT_EQ(bar.text, "1 m") << "of 3 m with data";
    EXPECT_LT(bar.from.y, whole.from.y) << "nearer to them";
}

/// The smallest and largest place of ink on a canvas, as a box.
CanvasBox ink_box(const Image& image) {
    int left = image.width;
    int right = 0;
    int top = image.height;
    int bottom = 0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const Pixel pixel = pixel_at(image, x, y);
            if (*std::min_element(pixel.begin(), pixel.end()) > 250) continue;
            left = std::min(left, x);
            right = std::max(right, x + 1);
            top = std::min(top, y);
            bottom = std::max(bottom, y + 1);
        }
    }
    return {static_cast<double>(left), static_cast<double>(top), static_cast<double>(right - left),
            static_cast<double>(bottom - top)};
}

TEST(PicturePanels, DrawNothingOutsideTheirMargins) {
    std::vector<std::pair<const char*, std::unique_ptr<PanelContent>>> panels;
    Snapshot wavy = wavy_bed(40, 30);
    Snapshot wet = under_water(wavy, 0.01, 0.3);
    for (const BarPosition bar : {BarPosition::none, BarPosition::right, BarPosition::below}) {
        for (const bool axes : {false, true}) {
            MapPanelSettings settings;
            settings.axes = axes;
            settings.colour_bar = bar;
            settings.scale_bar = settings.compass = true;
            settings.label = "t = 10 s";
            settings.arrow = flow_direction();
            if (axes) settings.flow = water_flow_of(wet);
            panels.emplace_back(
                "map", std::make_unique<MapPanel>(map_picture(heights(), wet, wet), settings));
        }
    }
    for (const double azimuth : {180.0, 215.0, 280.0}) {
        ViewSettings settings;
        settings.label = "step 300";
        settings.arrow = wind_direction(Snapshot{});
        settings.compass = true;
        settings.colour_bar = azimuth == 215.0 ? BarPosition::right : BarPosition::none;
        settings.colours = {read_palette("vik"), -1.0, 1.0, "change (mm)"};
        panels.emplace_back("view", std::make_unique<ViewPanel>(block_picture(azimuth), settings));
    }
    const auto ridge = moving_ridge({0, 5, 10});
    panels.emplace_back("time-space",
                        std::make_unique<TimeSpacePanel>(time_space_picture(heights(), ridge, 1)));
    ProfilePicture profiles = profile_picture(ridge, 1);
    profiles.wind = wind_direction(Snapshot{});
    panels.emplace_back("profiles", std::make_unique<ProfilePanel>(profiles));
    profiles.lines.resize(1);
    panels.emplace_back("profile", std::make_unique<ProfilePanel>(profiles));
    const Snapshot air = eddy_section(48, 32);
    for (const SectionPanel panel : {SectionPanel::velocity, SectionPanel::paths})
        panels.emplace_back("section", make_section_panel({}, air, panel));
    for (const auto& [name, panel] : panels) {
        for (const auto& [width, height] :
             {std::pair{120.0, 90.0}, {260.0, 130.0}, {200.0, 260.0}}) {
            for (const double font : {8.0, 14.0}) {
                const double aspect = panel->aspect();
                const double shown_width = aspect > 0.0 ? std::min(width, aspect * height) : width;
                const CanvasBox frame{150.0, 110.0, shown_width,
                                      aspect > 0.0 ? shown_width / aspect : height};
                Canvas canvas(600, 600, font);
                const PanelMargins room = panel->margins(canvas, frame.width, frame.height);
                panel->draw(canvas, frame);
                const CanvasBox ink = ink_box(canvas.image());
                const CanvasBox promised{frame.x - room.left, frame.y - room.above,
                                         frame.width + room.left + room.right,
                                         frame.height + room.above + room.below};
                EXPECT_TRUE(within(ink, promised, 1.0))
                    << name << ", frame " << frame.width << " x " << frame.height << ", font "
                    << font << ": ink " << ink.x << " " << ink.y << " " << ink.right() << " "
                    << ink.bottom() << ", promised " << promised.x << " " << promised.y << " "
                    << promised.right() << " " << promised.bottom();
            }
        }
    }
}

}  // namespace
}  // namespace fumon
