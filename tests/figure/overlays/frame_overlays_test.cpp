#include "figure/overlays/frame_overlays.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "base/error.h"
#include "figure/canvas/canvas_box.h"
#include "render/view/framing.h"
#include "support/overlay_scenes.h"
#include "support/section_beds.h"

namespace fumon {
namespace {

constexpr std::array corners{"upper-left", "upper-middle", "upper-right",
                             "lower-left", "lower-middle", "lower-right"};
constexpr std::array kinds{"title",      "time",       "scale-bar", "arrow",
                           "colour-bar", "parameters", "plot"};

int changed_pixels(const Image& before, const Image& after, const CanvasBox& box) {
    int count = 0;
    for (int y = static_cast<int>(box.y); y < static_cast<int>(box.bottom()); ++y) {
        for (int x = static_cast<int>(box.x); x < static_cast<int>(box.right()); ++x) {
            if (before.row(y)[3 * x] != after.row(y)[3 * x]) ++count;
        }
    }
    return count;
}

TEST(FrameOverlays, EveryKindInEveryCornerStaysInThePictureAndApart) {
    const Snapshot first = overlay_bed(120, 90, 0.5);
    for (const auto& [width, height] : {std::pair{1920, 1080}, std::pair{480, 270}}) {
        const CanvasBox picture{0.0, 0.0, static_cast<double>(width), static_cast<double>(height)};
        for (std::size_t turn = 0; turn < corners.size(); ++turn) {
            std::string overlays;
            for (std::size_t kind = 0; kind < kinds.size(); ++kind)
                overlays += overlay(kinds.at(kind), corners.at((kind + turn) % corners.size()));
            const Scene scene = scene_of(overlays, width, height);
            FrameOverlays over(scene, first);
            ASSERT_EQ(over.placed().size(), kinds.size());
            for (std::size_t i = 0; i < kinds.size(); ++i) {
                const CanvasBox& box = over.placed()[i].box;
                EXPECT_TRUE(within(box, picture)) << kinds.at(i);
                for (std::size_t j = 0; j < i; ++j)
                    EXPECT_FALSE(overlap(box, over.placed()[j].box)) << kinds.at(i);
            }
            const Image before = grey(width, height);
            Image after = before;
            const MeasuredRows rows = rows_up_to(20);
            over.draw(after, {first, rows, {0.0, 4.0}});
            int within_boxes = 0;
            for (std::size_t i = 0; i < kinds.size(); ++i) {
                const int changed = changed_pixels(before, after, over.placed()[i].box);
                EXPECT_GT(changed, 100) << kinds.at(i);
                within_boxes += changed;
            }
            EXPECT_EQ(changed_pixels(before, after, picture), within_boxes);
        }
    }
}

TEST(FrameOverlays, SeveralInOneCornerStandBelowOneAnotherInTheScenesOrder) {
    const Snapshot first = overlay_bed(120, 90, 0.5);
    for (const char* corner : corners) {
        std::string overlays;
        for (const char* kind : kinds) overlays += overlay(kind, corner);
        const FrameOverlays over(scene_of(overlays, 1920, 1080), first);
        for (std::size_t i = 1; i < kinds.size(); ++i)
            EXPECT_GT(over.placed()[i].box.y, over.placed()[i - 1].box.bottom()) << corner;
    }
}

TEST(FrameOverlays, WhatIsSwitchedOffIsNotThere) {
    const Snapshot first = overlay_bed(60, 40, 0.5);
    const Scene scene = scene_of(
        overlay("title", "upper-left", "show = false") + overlay("time", "upper-left"), 640, 360);
    const Scene alone = scene_of(overlay("time", "upper-left"), 640, 360);
    FrameOverlays over(scene, first);
    FrameOverlays same(alone, first);
    ASSERT_EQ(over.placed().size(), 1U);
    EXPECT_EQ(over.placed()[0].number, 1U);
    Image one = grey(640, 360);
    Image two = one;
    over.draw(one, {first, {}, {}});
    same.draw(two, {first, {}, {}});
    EXPECT_EQ(one, two);
    EXPECT_FALSE(has_overlays(scene_of(overlay("plot", "upper-left", "show = false"), 64, 48)));
    EXPECT_TRUE(
        plotted_columns(scene_of(overlay("plot", "upper-left", "show = false"), 64, 48)).empty());
}

TEST(FrameOverlays, WhiteInkStandsOnADarkPlate) {
    const Snapshot first = overlay_bed(40, 30, 0.5);
    const auto drawn = [&](const std::string& more) {
        const Scene scene = scene_of(overlay("title", "upper-left", more), 480, 270);
        FrameOverlays over(scene, first);
        Image image = grey(480, 270);
        over.draw(image, {first, {}, {}});
        const CanvasBox& box = over.placed().front().box;
        const int x = static_cast<int>(box.x + 0.5 * box.width);
        int low = 255;
        int high = 0;
        for (int y = static_cast<int>(box.y); y < static_cast<int>(box.bottom()); ++y) {
            for (int at = x - 40; at < x + 40; ++at) {
                low = std::min<int>(low, image.row(y)[3 * at]);
                high = std::max<int>(high, image.row(y)[3 * at]);
            }
        }
        return std::pair(low, high);
    };
    const auto [black_low, black_high] = drawn("opacity = 1");
    EXPECT_LT(black_low, 40);
    EXPECT_GT(black_high, 240);
    const auto [plate, letters] = drawn("opacity = 0.5\nink = \"white\"");
    EXPECT_LT(plate, 100) << "the plate is darker than the picture";
    EXPECT_GT(letters, 200);
    const auto [around, bare] = drawn("opacity = 0\nink = \"white\"");
    EXPECT_LT(around, 127) << "a shadow";
    EXPECT_GT(bare, 200);
}

TEST(FrameOverlays, StandBelowWhatTakesTheUpperEdge) {
    const Snapshot first = overlay_bed(40, 30, 0.5);
    const Scene scene = scene_of(overlay("title", "upper-left"), 480, 270);
    OverlayStyle style;
    style.edge = 12.0;
    EXPECT_EQ(FrameOverlays(scene, first, style).placed().front().box.y, 12.0);
    style.under = 20.0;
    EXPECT_EQ(FrameOverlays(scene, first, style).placed().front().box.y, 26.0);
}

TEST(FrameOverlays, APlateIsBlendedInDisplayValues) {
    const Snapshot first = overlay_bed(60, 40, 0.5);
    for (const double opacity : {0.0, 0.25, 0.6, 1.0}) {
        const Scene scene =
            scene_of(overlay("time", "upper-left", fmt::format("opacity = {}", opacity)), 640, 360);
        FrameOverlays over(scene, first);
        Image image = grey(640, 360, 100);
        over.draw(image, {first, {}, {}});
        const CanvasBox& box = over.placed()[0].box;
        // Between the plate's edge and the text.
        const int x = static_cast<int>(box.x + 0.5 * box.width);
        const int y = static_cast<int>(box.y) + 1;
        EXPECT_NEAR(image.row(y)[3 * x], 100.0 + 155.0 * opacity, 1.5);
    }
}

/// Pixels on the two outermost columns of a box that are not those of its plate.
int inked_at_ends(const Image& image, const CanvasBox& box) {
    int count = 0;
    const int right = static_cast<int>(box.right()) - 1;
    for (int y = static_cast<int>(box.y); y < static_cast<int>(box.bottom()); ++y) {
        for (const int x : {static_cast<int>(box.x), right - 1, right}) {
            if (image.row(y)[3 * x] < 120) ++count;
        }
    }
    return count;
}

TEST(FrameOverlays, ATimeIsWholeHoweverLongItsText) {
    struct Case {
        std::int64_t last;
        std::int64_t step;
        double time;
    };
    // Years of dunes: of a length that the scene does not say, with decimals below 10.
    for (const auto& [last, step, time] :
         {Case{20, 20, 0.13}, Case{1, 1, 0.01}, Case{20, 20, 7.5}, Case{8000, 8000, 53.0},
          Case{20, 999'999, 0.99}, Case{7, 123'456'789, 123'456'789.0}}) {
        for (const auto& [width, height] :
             {std::pair{1920, 1080}, std::pair{641, 357}, std::pair{333, 222}}) {
            for (const char* text :
                 {"", "text = \"{time}\"", "text = \"{time} after {step} of it\""}) {
                const Scene scene = parse_scene(
                    fmt::format("[model]\nname = \"dunes\"\n[run]\nsteps = {}\n[image]\n"
                                "width = {}\nheight = {}\n{}",
                                last, width, height, overlay("time", "upper-left", text)),
                    "test.toml", "");
                Snapshot frame = overlay_bed(60, 40, 0.5);
                frame.time_unit = "yr";
                FrameOverlays over(scene, frame);
                frame.step = step;
                frame.time = time;
                Image image = grey(width, height);
                over.draw(image, {frame, {}, {}});
                EXPECT_EQ(inked_at_ends(image, over.placed()[0].box), 0)
                    << last << ' ' << time << ' ' << width << ' ' << text;
            }
        }
    }
}

/// The longest run of black pixels of a row.
int longest_dark_run(const Image& image) {
    int longest = 0;
    for (int y = 0; y < image.height; ++y) {
        int run = 0;
        for (int x = 0; x < image.width; ++x) {
            run = image.row(y)[3 * x] < 60 ? run + 1 : 0;
            longest = std::max(longest, run);
        }
    }
    return longest;
}

TEST(ScaleBarOverlay, IsAsLongAsItsMetresInMapsAndOrthographicViews) {
    for (const char* projection : {"map", "orthographic"}) {
        for (const auto& [nx, ny, cell] :
             {std::tuple{120, 90, 0.5}, {64, 200, 3.0}, {300, 40, 0.002}, {90, 90, 0.0}}) {
            const Snapshot first = overlay_bed(nx, ny, cell);
            const Scene scene = scene_of(
                overlay("scale-bar", "lower-left", "opacity = 0.0"), 1280, 720,
                fmt::format("[camera]\nprojection = \"{}\"\nazimuth = 230\nelevation = 35\n",
                            projection));
            FrameOverlays over(scene, first);
            Image image = grey(1280, 720);
            over.draw(image, {first, {}, {}});

            // A length across the picture, seen by the camera itself.
            const Block block = framed_block(scene.view, first);
            const Camera camera = camera_at_step(scene.view, block, 0, 1200);
            const double seen =
                0.5 * 1280.0 *
                (project(camera, camera.right).x - project(camera, glm::dvec3(0.0)).x);
            const double pixels_per_metre = seen / block.side;
            double longest = 0.0;
            for (int power = -6; power <= 6; ++power) {
                for (const double step : {1.0, 2.0, 5.0}) {
                    const double pixels = step * std::pow(10.0, power) * pixels_per_metre;
                    if (pixels <= 0.2 * 1280.0) longest = std::max(longest, pixels);
                }
            }
            EXPECT_NEAR(longest_dark_run(image), longest, 1.5)
                << projection << " " << nx << " x " << ny << " cells of " << cell;
        }
    }
}

TEST(ScaleBarOverlay, IsTrueAtWhatAMovingCameraLooksAt) {
    const Snapshot bed = overlay_bed(120, 90, 0.5);
    const Scene scene = scene_of(overlay("scale-bar", "lower-left", "opacity = 0.0"), 1280, 720);
    FrameOverlays over(scene, bed, {false, true, 0.0});
    Block block = framed_block(scene.view, bed);
    for (const double distance : {0.4, 0.9, 2.3}) {
        block.look_at = glm::dvec3(0.1, -0.2, 0.0);
        block.eye = *block.look_at + distance * glm::dvec3(0.6, 0.0, 0.8);
        const Camera camera = place_camera(scene.view.camera, block, 1280.0 / 720.0, 0.0);
        for (const std::int64_t height : {std::int64_t{0}, std::int64_t{480}}) {
            Image image = grey(1280, 720);
            over.draw(image, {bed, {}, {}, &camera, height});
            const double metre = project(camera, *block.look_at + camera.right / block.side).x -
                                 project(camera, *block.look_at).x;
            const double pixels = 0.5 * metre * (height > 0 ? 1280.0 * 480.0 / 720.0 : 1280.0);
            const double metres = longest_dark_run(image) / pixels;
            const double digit = metres / std::pow(10.0, std::floor(std::log10(metres * 1.05)));
            const double off = std::min(
                {std::abs(digit - 1.0), std::abs(digit / 2.0 - 1.0), std::abs(digit / 5.0 - 1.0)});
            EXPECT_LE(off, 1.5 / longest_dark_run(image)) << distance << " " << metres;
            EXPECT_LE(longest_dark_run(image), 0.2 * 1280.0 + 1.5);
            EXPECT_GE(longest_dark_run(image), 0.08 * 1280.0 - 1.5);
        }
    }
}

/// The largest patch of dark pixels that touch one another.
std::vector<CanvasPoint> largest_dark_patch(const Image& image) {
    std::vector<char> dark(image.rgb.size() / 3);
    for (std::size_t i = 0; i < dark.size(); ++i) dark[i] = image.rgb[3 * i] < 60 ? 1 : 0;
    const auto width = static_cast<std::size_t>(image.width);
    std::vector<CanvasPoint> largest;
    for (std::size_t start = 0; start < dark.size(); ++start) {
        std::vector<std::size_t> open;
        std::vector<CanvasPoint> patch;
        const auto take = [&](std::size_t i) {
            if (i >= dark.size() || dark[i] == 0) return;
            dark[i] = 0;
            open.push_back(i);
        };
        take(start);
        while (!open.empty()) {
            const std::size_t i = open.back();
            open.pop_back();
            patch.push_back({static_cast<double>(i % width), static_cast<double>(i / width)});
            for (const std::size_t next : {i - 1, i + 1, i - width, i + width}) take(next);
        }
        if (patch.size() > largest.size()) largest = std::move(patch);
    }
    return largest;
}

/// The direction of an arrow's long axis, towards its head: the other end reaches further from the
/// middle of its pixels.
std::array<double, 2> long_axis(const std::vector<CanvasPoint>& arrow) {
    const auto n = static_cast<double>(arrow.size());
    CanvasPoint middle;
    for (const CanvasPoint& point : arrow) {
        middle.x += point.x / n;
        middle.y += point.y / n;
    }
    double xx = 0.0;
    double yy = 0.0;
    double xy = 0.0;
    for (const CanvasPoint& point : arrow) {
        xx += (point.x - middle.x) * (point.x - middle.x);
        yy += (point.y - middle.y) * (point.y - middle.y);
        xy += (point.x - middle.x) * (point.y - middle.y);
    }
    const double angle = 0.5 * std::atan2(2.0 * xy, xx - yy);
    double skew = 0.0;
    for (const CanvasPoint& point : arrow) {
        const double along =
            (point.x - middle.x) * std::cos(angle) + (point.y - middle.y) * std::sin(angle);
        skew -= along * along * along;
    }
    const double sign = skew > 0.0 ? 1.0 : -1.0;
    return {sign * std::cos(angle), sign * std::sin(angle)};
}

TEST(ArrowOverlay, PointsWhereTheCameraSeesTheWindBlowAlsoWhileItTurns) {
    const Snapshot first = overlay_bed(100, 100, 1.0);
    for (const double elevation : {88.0, 50.0}) {
        for (const double azimuth : {180.0, 200.0, 155.0, 20.0, 330.0}) {
            const std::string camera = fmt::format(
                "[camera]\nprojection = \"orthographic\"\nazimuth = {}\nelevation = {}\n"
                "turn = 12.0\n",
                azimuth, elevation);
            const Scene scene =
                scene_of(overlay("arrow", "upper-right", "font_size = 60\nopacity = 0.0"), 1280,
                         720, camera);
            FrameOverlays over(scene, first);
            for (const std::int64_t step : {0, 1200}) {
                Snapshot snapshot = first;
                snapshot.step = step;
                Image image = grey(1280, 720);
                over.draw(image, {snapshot, {}, {}});
                const auto seen = long_axis(largest_dark_patch(image));
                const double angle = (azimuth + 12.0 * static_cast<double>(step) / 1200.0) *
                                     std::numbers::pi / 180.0;
                const double across = -std::cos(angle);
                const double down =
                    std::sin(angle) * std::sin(elevation * std::numbers::pi / 180.0);
                const double length = std::hypot(across, down);
                EXPECT_GT((seen[0] * across + seen[1] * down) / length, 0.995)
                    << azimuth << " " << elevation << " step " << step << ": " << seen[0] << " "
                    << seen[1] << " not " << across / length << " " << down / length;
            }
        }
    }
}

std::string refusal(const Scene& scene, const Snapshot& first) {
    try {
        const FrameOverlays over(scene, first);
    } catch (const KeyError& error) {
        return error.key() + ": " + error.what();
    }
    return "";
}

TEST(FrameOverlays, NameWhatDoesNotFit) {
    const Snapshot first = overlay_bed(60, 40, 0.5);
    const auto refused = [&](const std::string& overlays, const std::string& more = "",
                             int width = 640, int height = 360) {
        return refusal(scene_of(overlays, width, height, more), first);
    };
    EXPECT_TRUE(refused(overlay("time", "upper-left") +
                        overlay("plot", "upper-left", "y = \"wavelength_spectra\""))
                    .starts_with("overlay.1.y: the measurements of sand have no column "
                                 "wavelength_spectra; did you mean \"wavelength_spectrum\"?"));
    EXPECT_TRUE(refused(overlay("plot", "upper-left", "low = 3.0\nhigh = 2.0"))
                    .starts_with("overlay.0.high: "));
    EXPECT_TRUE(refused(overlay("time", "upper-left", "text = \"{tome}\""))
                    .starts_with("overlay.0.text: {tome} is not a placeholder"));
    EXPECT_TRUE(
        refused(overlay("title", "upper-left") + overlay("plot", "upper-left"), "", 64, 48)
            .starts_with("overlay.0.kind: overlay.0 does not fit into a picture of 64 x 48"));
    EXPECT_TRUE(refused(overlay("title", "upper-left", "font_size = 200"))
                    .starts_with("overlay.0.font_size: overlay.0 does not fit into a picture"));
    EXPECT_TRUE(
        refused(overlay("title", "upper-left") + overlay("time", "lower-left"), "", 480, 270)
            .empty());

    Scene natural = scene_of(overlay("colour-bar", "upper-left"), 640, 360);
    natural.view.look.colour_by = Colouring::natural;
    EXPECT_TRUE(refusal(natural, first).starts_with("overlay.0.kind: "));
    Scene nameless = scene_of(overlay("title", "upper-left"), 640, 360);
    nameless.title.clear();
    EXPECT_TRUE(refusal(nameless, first).starts_with("overlay.0.kind: "));
    Scene flat = scene_of(overlay("scale-bar", "upper-left"), 640, 360);
    flat.view.look.mode = ViewMode::figure;
    EXPECT_TRUE(refusal(flat, eddy_section()).starts_with("overlay.0.kind: "));
    EXPECT_THROW(
        scene_of(overlay("parameters", "upper-left", "keys = [\"model.crep_rate\"]"), 64, 48),
        InputError);
}

TEST(FrameOverlays, ParametersAreTheWrittenKeysOfTheModel) {
    const Scene scene = scene_of(overlay("parameters", "upper-left"), 640, 360);
    EXPECT_EQ(scene.view.overlays[0].keys, std::vector<std::string>{"model.creep_rate"});
    Scene bare = parse_scene(
        "[model]\nname = \"sand\"\n[run]\nsteps = 1\n" + overlay("parameters", "upper-left"),
        "test.toml", "");
    name_parameter_keys(bare);
    EXPECT_EQ(bare.view.overlays[0].keys, std::vector<std::string>{"model.name"});
}

TEST(FrameOverlays, StandOverASectionsFigureAndAStripToo) {
    Snapshot section = eddy_section();
    section.time_unit = "s";
    const Scene scene = parse_scene(
        "title = \"air\"\n[model]\nname = \"airflow\"\n[run]\nsteps = 10\n[look]\nmode = "
        "\"figure\"\n[image]\nwidth = 1280\nheight = 720\n" +
            overlay("title", "upper-left") + overlay("arrow", "lower-left") +
            overlay("plot", "upper-right", "y = \"mean_height\""),
        "test.toml", "");
    FrameOverlays over(scene, section);
    Image image = grey(1280, 720);
    over.draw(image, {section, {}, {}});
    EXPECT_EQ(over.placed().size(), 3U);

    Snapshot profile = overlay_bed(400, 1, 0.0);
    const Scene strip = scene_of(
        overlay("scale-bar", "upper-left") + overlay("plot", "upper-right", "y = \"celerity\""),
        1280, 720);
    EXPECT_EQ(FrameOverlays(strip, profile).placed().size(), 2U);
}

}  // namespace
}  // namespace fumon
