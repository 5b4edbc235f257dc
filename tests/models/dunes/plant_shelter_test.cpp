#include "models/dunes/plants/plant_shelter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/snapshot_lookup.h"
#include "base/worker_pool.h"
#include "models/dunes/dunes.h"
#include "models/dunes/plants/plants.h"
#include "models/shared/state_hash.h"
#include "support/temporary_folder.h"

namespace fumon::test {
namespace {

constexpr double cover_of_okin = 0.55;

/// Shrubs on a bar of ground, and none elsewhere.
DunesParameters bar_of_shrubs(double cover, double x, double y, double length, double width) {
    DunesParameters dunes;
    dunes.plants = DunePlants::fixed;
    dunes.plant_shelter = DunePlantShelter::okin;
    dunes.shrubs.cover = cover;
    dunes.features = {{FeatureKind::shrubs, FeatureShape::block, x, y, length, width, 0.0, 90.0}};
    return dunes;
}

Grid stress_of(const DunesParameters& dunes, const DuneGround& ground, const BlowingWind& wind) {
    WorkerPool pool(1);
    const DuneBed bed{FixedPointGrid(ground.nx, ground.ny), FixedPointGrid(ground.nx, ground.ny),
                      FixedPointGrid(ground.nx, ground.ny)};
    const Plants plants(dunes, ground, bed, 1, pool);
    PlantShelter shelter(dunes, ground, pool);
    shelter.set_plants(plants);
    shelter.find(wind);
    return shelter.stress();
}

/// u*s / u* at a distance behind plants of a cover and a height.
double okin(double cover, double height, double distance) {
    const double least = 1.0 / std::sqrt(1.0 + 16.0 * cover);
    return least + (1.0 - least) * (1.0 - std::exp(-distance / (4.8 * height)));
}

/// A bar of shrubs across the grid; behind it each wind finds the formula at its own distance, also
/// over the periodic edges.
TEST(PlantShelter, RecoversBehindPlantsAsOkinHasItInAnyDirection) {
    constexpr int n = 80;
    const DuneGround ground{n, n, 0.5, 0.5, true, true};
    const double height = 1.1 * std::sqrt(cover_of_okin);
    const DunesParameters columns = bar_of_shrubs(cover_of_okin, 30.0, 20.0, 2.0, 80.0);
    const DunesParameters rows = bar_of_shrubs(cover_of_okin, 20.0, 30.0, 80.0, 2.0);
    for (const double degrees : {0.0, 20.0, -40.0, 160.0, 180.0}) {
        const double angle = degrees * 3.14159265358979323846 / 180.0;
        const double ahead = std::cos(angle);
        const Grid along_x = stress_of(columns, ground, {ahead, std::sin(angle)});
        const Grid along_y = stress_of(rows, ground, {std::sin(angle), ahead});
        // Plants stand on the cells 58 to 61.
        for (int cells = 0; cells < 70; ++cells) {
            const int at = ahead > 0.0 ? (61 + cells) % n : (58 - cells + n) % n;
            const double distance = cells * 0.5 / std::abs(ahead);
            const double expected = okin(cover_of_okin, height, distance);
            for (const int across : {0, 31}) {
                EXPECT_NEAR(std::sqrt(along_x(at, across)), expected, 1e-9)
                    << degrees << " degrees, " << cells << " cells behind";
                EXPECT_NEAR(std::sqrt(along_y(across, at)), expected, 1e-9)
                    << degrees << " degrees, " << cells << " cells behind";
            }
        }
    }
    EXPECT_NEAR(okin(cover_of_okin, height, 0.0), 0.32, 0.001) << "Okin's own number";
}

TEST(PlantShelter, DeepestShelterOfTwoPlantsHoldsAndOpenEdgesBringNone) {
    const DuneGround ground{60, 6, 1.0, 1.0, false, false};
    DunesParameters dunes = bar_of_shrubs(0.6, 10.5, 3.0, 1.0, 6.0);
    dunes.grass.cover = 0.3;
    dunes.features.push_back(
        {FeatureKind::grass, FeatureShape::block, 13.5, 3.0, 1.0, 6.0, 0.0, 90.0});
    const Grid stress = stress_of(dunes, ground, {1.0, 0.0});
    EXPECT_EQ(stress(9, 3), 1.0) << "before them";
    const double shrubs = 1.1 * std::sqrt(0.6);
    EXPECT_NEAR(std::sqrt(stress(12, 3)), okin(0.6, shrubs, 2.0), 1e-9);
    EXPECT_NEAR(stress(13, 3), 1.0 / (1.0 + 16.0 * 0.3), 1e-9) << "the grass";
    EXPECT_NEAR(std::sqrt(stress(14, 3)), okin(0.3, 0.45 * std::sqrt(0.3), 1.0), 1e-9);
    EXPECT_EQ(stress_of(dunes, ground, {-1.0, 0.0})(20, 3), 1.0);
}

TEST(PlantShelter, RaupachSheltersAmongPlantsAlone) {
    const DuneGround ground{20, 8, 1.0, 1.0, true, true};
    DunesParameters dunes = bar_of_shrubs(0.25, 10.0, 4.0, 2.0, 8.0);
    dunes.plant_shelter = DunePlantShelter::raupach;
    const Grid stress = stress_of(dunes, ground, {1.0, 0.0});
    EXPECT_NEAR(stress(10, 4), 0.2, 1e-9) << "1 / (1 + 16 / 4)";
    EXPECT_EQ(stress(11, 4), 1.0);
}

TEST(PlantShelter, WindLiftsAsItsStressLessTheThreshold) {
    const BlowingWind strong{1.0, 0.0, 1.0, 0.0};
    const BlowingWind near_threshold{1.0, 0.0, 1.0, 0.25};
    EXPECT_EQ(PlantShelter::lifted_under(1.7, 1.0, near_threshold), 1.7);
    EXPECT_DOUBLE_EQ(PlantShelter::lifted_under(1.7, 0.4, strong), 0.68);
    EXPECT_DOUBLE_EQ(PlantShelter::lifted_under(1.0, 0.4, near_threshold), (0.4 - 0.25) / 0.75);
    EXPECT_EQ(PlantShelter::lifted_under(1.0, 0.25, near_threshold), 0.0);
    EXPECT_EQ(PlantShelter::lifted_under(1.0, 0.1, near_threshold), 0.0);
}

/// Gusts bring sand over rock to one bush, and it stays in the lee, too: a shadow dune.
TEST(PlantShelter, BushesOnRockGetTailsOfSand) {
    WorkerPool pool(1);
    constexpr int nx = 60;
    constexpr int ny = 40;
    const auto tail = [&](DunePlantShelter shelter) {
        DunesParameters dunes = bar_of_shrubs(0.6, 8.0, 10.0, 2.0, 2.0);
        dunes.plant_shelter = shelter;
        dunes.edges_x = DuneEdge::open;
        dunes.influx = 0.3;
        dunes.flux = 20.0;
        DuneWind wind;
        wind.gust_angle = 15.0;
        wind.gust_duration = 0.002;
        wind.threshold_ratio = {"", 2.0};
        dunes.winds = {wind};
        Dunes model(dunes, {Grid(nx, ny), {}, {0.5, 0.5, 1.0, true}, 7, pool});
        for (int step = 0; step < 600; ++step) model.step();
        constexpr int behind = 18;
        int end = behind;
        while (end < nx && model.bed().surface(end, ny / 2) > to_units(0.05)) ++end;
        return 0.5 * (end - behind);
    };
    const double behind_okin = tail(DunePlantShelter::okin);
    EXPECT_GE(behind_okin, 2.0) << "as long as the bush";
    EXPECT_LE(tail(DunePlantShelter::raupach), behind_okin - 0.5);
    EXPECT_LE(tail(DunePlantShelter::none), 0.5);
}

/// A blow-out in a plain of grass and shrubs whose heap walks on: plants hold its flanks, which
/// become arms many times as long as the bare lobe.
TEST(PlantShelter, ParabolicDunesHaveArmsFiveTimesAsLongAsTheirLobes) {
    WorkerPool pool(1);
    constexpr int nx = 100;
    constexpr int ny = 36;
    constexpr double plain = 1.6;
    const auto arms_over_lobe = [&] {
        DunesParameters dunes;
        dunes.plants = DunePlants::grow;
        dunes.plant_shelter = DunePlantShelter::okin;
        dunes.saturation_length = {"hops", 0.0};
        dunes.flux = 6.0;
        dunes.grass.cover = 0.6;
        dunes.shrubs.cover = 0.5;
        dunes.plant_spread = 0.5;
        DuneWind wind;
        wind.gust_angle = 15.0;
        wind.gust_duration = 0.02;
        wind.threshold_ratio = {"", 2.0};
        dunes.winds = {wind};
        dunes.features = {
            {FeatureKind::clearing, FeatureShape::hill, 30.0, 36.0, 44.0, 36.0, 0.0, 90.0},
            {FeatureKind::sand, FeatureShape::hill, 36.0, 36.0, 40.0, 34.0, 5.0, 90.0}};
        Dunes model(dunes, {Grid(nx, ny, plain), {}, {2.0, 2.0, 1.0, true}, 4, pool});
        for (int step = 0; step < 3000; ++step) model.step();
        const Snapshot snapshot = model.snapshot();
        const Grid& cover = *field_of(snapshot.fields, "cover");
        // The lobe: columns with five bare cells half a metre above the plain.
        int foot = nx;
        int nose = 0;
        for (int x = 0; x < nx; ++x) {
            int bare = 0;
            for (int y = 0; y < ny; ++y)
                bare += cover(x, y) < 0.1 && snapshot.bed(x, y) > plain + 0.5 ? 1 : 0;
            if (bare < 5) continue;
            foot = std::min(foot, x);
            nose = x;
        }
        // The shorter arm: overgrown ground as high, upwind of it.
        int shorter = nx;
        for (const int side : {0, ny / 2}) {
            int x = foot;
            const auto rises = [&](int column) {
                for (int y = side; y < side + ny / 2; ++y) {
                    if (cover(column, y) > 0.2 && snapshot.bed(column, y) > plain + 0.5)
                        return true;
                }
                return false;
            };
            while (x > 0 && (rises(x - 1) || (x > 1 && rises(x - 2)))) --x;
            shorter = std::min(shorter, foot - x);
        }
        return static_cast<double>(shorter) / std::max(nose + 1 - foot, 1);
    };
    EXPECT_GT(arms_over_lobe(), 5.0);
}

TEST(PlantShelter, SandIsKeptAndAnyThreadsGiveTheSame) {
    std::vector<Sha256> hashes;
    for (const int threads : {1, 2, 5}) {
        WorkerPool pool(threads);
        DunesParameters dunes;
        dunes.plants = DunePlants::grow;
        dunes.plant_shelter = DunePlantShelter::okin;
        dunes.shrubs.cover = 0.5;
        dunes.shrubs.share = 0.1;
        dunes.growth_period = 0.01;
        DuneWind wind;
        wind.from = 250.0;
        wind.gust_angle = 40.0;
        wind.gust_duration = 0.002;
        wind.threshold_ratio = {"", 1.5};
        dunes.winds = {wind};
        ModelSetup setup{Grid(90, 50, 0.5), {}, {1.0, 1.0, 1.0, true}, 7, pool};
        for (int x = 40; x < 60; ++x) setup.bed(x, 25) = 3.0;
        Dunes model(dunes, setup);
        const auto sand = [&] {
            std::int64_t sum = 0;
            for (std::size_t cell = 0; cell < model.bed().surface.size(); ++cell)
                sum += model.bed().surface.values()[cell] + model.bed().moving.values()[cell];
            return sum;
        };
        const std::int64_t before = sand();
        for (int step = 0; step < 30; ++step) model.step();
        EXPECT_EQ(sand(), before);
        const Snapshot snapshot = model.snapshot();
        const Grid* shelter = field_of(snapshot.fields, "plant_shelter");
        ASSERT_NE(shelter, nullptr);
        const auto [low, high] = std::ranges::minmax(shelter->values());
        EXPECT_GE(low, 0.0);
        EXPECT_GT(high, 0.6);
        hashes.push_back(state_hash(model));
    }
    EXPECT_EQ(hashes[0], hashes[1]);
    EXPECT_EQ(hashes[0], hashes[2]);
}

TEST(PlantShelter, NeedsPlantsAndContinuousTransport) {
    WorkerPool pool(1);
    const auto refusal = [&](const DunesParameters& dunes) {
        return message_of<KeyError>([&] {
            Dunes(dunes, {Grid(20, 20, 1.0), {}, {1.0, 1.0, 1.0, true}, 7, pool});
        });
    };
    DunesParameters dunes;
    dunes.plant_shelter = DunePlantShelter::raupach;
    EXPECT_NE(refusal(dunes).find("there are no plants"), std::string::npos);
    dunes.plants = DunePlants::fixed;
    EXPECT_EQ(refusal(dunes), "");
    dunes.transport = DuneTransport::slabs;
    dunes.speed_up = DuneSpeedUp::none;
    EXPECT_NE(refusal(dunes).find("continuous transport only"), std::string::npos);
}

}  // namespace
}  // namespace fumon::test
