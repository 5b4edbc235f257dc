#include "render/life/track_layer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/error.h"
#include "picture/tile_similarity.h"
#include "support/drawn_picture.h"
#include "support/view_beds.h"

namespace fumon {
namespace {

/// A plain of 80 m by 60 m, 1.5 m high; periodic ones go on to the horizon.
Snapshot plain(bool periodic) {
    Snapshot bed;
    bed.bed = Grid(40, 30, 3.0);
    bed.scale = {2.0, 2.0, 0.5, true, {}};
    bed.periodic = periodic;
    return bed;
}

/// 5 m over the ground, north up, 5.36 m high: a pixel is 3 cm.
View from_above(double sun_azimuth = 90.0) {
    View view = small_view(240, 180);
    view.look.exaggeration = {"", 1.0};
    view.look.grain = 0.0;
    view.look.ripples = 0.0;
    view.camera.azimuth = 180.0;
    view.camera.elevation = 89.9;
    view.camera.at = {40.0, 30.0, 5.0};
    view.camera.look_at = {40.0, 30.001, 0.0};
    view.camera.field_of_view = 56.4;
    view.sun.azimuth = sun_azimuth;
    view.sun.elevation = 30.0;
    return view;
}

View with_track(View view) {
    view.tracks.resize(1);
    view.tracks[0].along = {40.0, 20.0, 40.0, 40.0};  // northward through the middle
    return view;
}

/// By how much a picture is brighter with a track, of pixels in its rows and columns.
class MadeByTrack {
  public:
    MadeByTrack(const View& view, const Snapshot& bed)
        : before_(picture(view, bed)), after_(picture(with_track(view), bed)) {}

    [[nodiscard]] int at(int x, int y) const {
        const std::size_t i = 3 * (static_cast<std::size_t>(y) * 240 + static_cast<std::size_t>(x));
        return int{after_.rgb[i + 1]} - int{before_.rgb[i + 1]};
    }
    /// Of the columns in a range, the rows in which one differs by more than a level or two.
    [[nodiscard]] std::vector<int> rows(int from, int to) const {
        std::vector<int> changed;
        for (int y = 0; y < 180; ++y) {
            for (int x = from; x < to; ++x) {
                if (std::abs(at(x, y)) <= 4) continue;
                changed.push_back(y);
                break;
            }
        }
        return changed;
    }

  private:
    Image before_;
    Image after_;
};

/// The lengths of the stretches of rows without a gap.
std::vector<int> stretches(const std::vector<int>& rows) {
    std::vector<int> lengths;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (i == 0 || rows[i] > rows[i - 1] + 1) lengths.push_back(0);
        ++lengths.back();
    }
    return lengths;
}

TEST(TrackLayer, MarksPrintsInTurnLeftAndRightOfTheLine) {
    for (const bool periodic : {false, true}) {
        const MadeByTrack track(from_above(), plain(periodic));
        const auto beside = [&](int from, int to) { return track.rows(from, to).size(); };
        EXPECT_EQ(beside(0, 111), 0U) << periodic;
        EXPECT_EQ(beside(129, 240), 0U) << periodic;
        const std::vector<int> left = track.rows(112, 119);
        const std::vector<int> right = track.rows(121, 128);
        // In 5.36 m there are seven steps; a print is, with the sand around it that gave way, some
        // 0.45 m long.
        for (const std::vector<int>& lengths : {stretches(left), stretches(right)}) {
            EXPECT_GE(lengths.size(), 3U) << periodic;
            EXPECT_LE(lengths.size(), 4U) << periodic;
            EXPECT_NEAR(*std::ranges::max_element(lengths), 15, 2) << periodic;
        }
        std::vector<int> both;
        std::ranges::set_intersection(left, right, std::back_inserter(both));
        EXPECT_LT(both.size(), left.size() / 3) << periodic;
    }
}

TEST(TrackLayer, ItsWallsAreLitByTheSun) {
    for (const bool periodic : {false, true}) {
        const double sun_azimuth = periodic ? 90.0 : 270.0;
        const MadeByTrack track(from_above(sun_azimuth), plain(periodic));
        double west = 0.0;
        double east = 0.0;
        const std::vector<int> left = track.rows(112, 119);
        const std::vector<int> right = track.rows(121, 128);
        for (const int y : left) {  // prints of the left foot, but not their outer rims
            if (std::ranges::count(right, y) > 0) continue;
            for (int x = 115; x < 117; ++x) west += track.at(x, y);
            for (int x = 118; x < 120; ++x) east += track.at(x, y);
        }
        const double towards = periodic ? 1.0 : -1.0;
        EXPECT_GT(towards * (west - east), 500.0) << periodic;
        EXPECT_LT(std::min(west, east), 0.0) << "a wall in its own shadow";
    }
}

TEST(TrackLayer, NoPrintIsSeenOnRockOrUnderWater) {
    View view = from_above();
    Snapshot bed = plain(true);
    view.look.mark = Marking::ground;
    const auto seen = [&] { return picture(with_track(view), bed) != picture(view, bed); };
    bed.fields = {{"sand", "", "m", Grid(40, 30, 1.0)}};
    EXPECT_TRUE(seen());
    bed.fields = {{"sand", "", "m", Grid(40, 30, 0.0)}};
    EXPECT_FALSE(seen()) << "rock";
    view.look.mark = Marking::none;
    bed.periodic = false;
    bed.landform = Landform::water;
    view.image.supersampling = 3;  // with 2 a block without tracks is coloured another way
    for (const double depth : {0.0, 0.1}) {
        bed.fields = {{"water_depth", "", "m", Grid(40, 30, depth)},
                      {"velocity_x", "", "m/s", Grid(40, 30)},
                      {"velocity_y", "", "m/s", Grid(40, 30)}};
        EXPECT_EQ(seen(), depth == 0.0) << depth;
    }
}

/// On a slope, the prints' lowest row: where sand slides they reach farther down.
TEST(TrackLayer, PrintsOnSlipFacesReachDownhill) {
    const auto rows_of_a_print = [](double degrees) {
        Snapshot bed = plain(false);
        for (int y = 0; y < 30; ++y) {
            for (int x = 0; x < 40; ++x) bed.bed(x, y) = 4.0 * y * std::tan(degrees * 0.017453293);
        }
        View view = from_above();
        view.tracks.resize(1);
        view.tracks[0].along = {40.0, 30.0, 40.8, 30.0};  // two steps, level
        const Image before = picture(from_above(), bed);
        const Image after = picture(view, bed);
        int lowest = 0;
        for (int y = 0; y < 180; ++y) {
            for (int x = 0; x < 240; ++x) {
                const std::size_t i =
                    3 * (static_cast<std::size_t>(y) * 240 + static_cast<std::size_t>(x));
                if (std::abs(int{before.rgb[i + 1]} - int{after.rgb[i + 1]}) > 4)
                    lowest = std::max(lowest, y);
            }
        }
        return lowest;  // south, which is down there
    };
    EXPECT_LT(rows_of_a_print(12.0), 90 + 10);  // 3 cm each
    EXPECT_GT(rows_of_a_print(32.0), 90 + 14);
}

TEST(TrackLayer, FadesWithDistanceWithoutFlicker) {
    View view = with_track(from_above());
    view.sun.azimuth = 60.0;
    view.tracks[0].along = {30.0, 20.0, 45.0, 45.0, 40.0, 200.0, 90.0, 500.0};
    view.camera.at = {32.0, 18.0, 1.7};
    view.camera.look_at = {42.0, 45.0, 0.0};
    view.camera.field_of_view = 28.0;
    view.image.width = 320;
    const Image before = picture(view, plain(true));
    view.camera.at = {32.001, 18.002, 1.7};
    const TileSimilarity similar = tile_similarity(before, picture(view, plain(true)));
    EXPECT_GE(similar.smallest, 0.98) << similar.x << ' ' << similar.y;
    view.tracks.clear();
    EXPECT_LT(tile_similarity(before, picture(view, plain(true))).smallest, 0.9)
        << "there is a track";
}

TEST(TrackLayer, TilesLeaveNoSeams) {
    View view = with_track(from_above());
    view.image.width = 397;
    view.camera.at = {40.0, 22.0, 1.7};
    view.camera.look_at = {40.0, 30.0, 0.0};
    const Snapshot bed = plain(true);
    const Image whole = picture(view, bed);
    RenderLimits limits;
    limits.tile_samples = 384;
    const Image tiled = picture(view, bed, 1, gl::Backend::automatic, limits);
    int apart = 0;
    for (std::size_t i = 0; i < whole.rgb.size(); ++i)
        apart = std::max(apart, std::abs(int{whole.rgb[i]} - int{tiled.rgb[i]}));
    EXPECT_LE(apart, 1);
}

TEST(TrackLayer, IsRefusedWhereItShowsNoScale) {
    Snapshot bed = plain(false);
    View view = from_above();
    view.tracks.resize(2);
    view.tracks[0].along = {10.0, 10.0, 20.0, 20.0};
    view.tracks[1].along = view.tracks[0].along;
    const auto fault = [&] {
        try {
            check_tracks(view, bed);
        } catch (const KeyError& error) {
            return error.key() + ": " + error.what();
        }
        return std::string();
    };
    const auto expect_fault = [&](const std::string& said) {
        EXPECT_NE(fault().find(said), std::string::npos) << fault();
    };
    EXPECT_EQ(fault(), "");
    std::vector<double>& along = view.tracks[1].along;
    for (const std::vector<double>& wrong :
         {std::vector<double>{}, {1.0, 2.0}, {1.0, 2.0, 3.0, 4.0, 5.0}}) {
        along = wrong;
        expect_fault("track.1.along: track.1.along is two points or more, two numbers each");
    }
    along = {1.0, 2.0, 90.0, 4.0};
    expect_fault("track.1.along, point 2 = [90, 4] is outside the bed, which is 80 x 60 m");
    along = {1.0, 2.0, 1.5, 2.0};
    expect_fault("track.1.along is 0.5 m long; a track is at least a step, 0.75 m");
    along.clear();
    for (int i = 0; i < 200; ++i) along.insert(along.end(), {1.0, 2.0, 79.0, 2.0});
    expect_fault(
        "track.1.along makes tracks of 31136.1 m; all of them together have at most "
        "20000 m");
    along = {1.0, 2.0, 3.0, 2.0};
    view.look.exaggeration = {"", 2.0};
    expect_fault("track.0.along: a track shows true sizes, but heights are exaggerated 2 times");
    view.look.exaggeration = {"", 1.0};
    view.look.mode = ViewMode::figure;
    expect_fault("a track is for scenic views (look.mode)");
    view.look.mode = ViewMode::scenic;
    bed.scale.in_metres = false;
    expect_fault("a track shows a scale, but this bed is not in metres");
}

}  // namespace
}  // namespace fumon
