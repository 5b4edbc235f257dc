// The tilted V catchment of Di Giammarco et al. (1996) beside the kinematic wave.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "files/csv_table.h"
#include "support/gully_run.h"

namespace fumon::test {
namespace tilted_v {
namespace {

constexpr double rain = 10.8 / 3.6e6;  // m/s, for rainy seconds
constexpr double rainy = 5400.0;
constexpr double plane_length = 800.0;  // m, down a slope of .05 with n = .015
constexpr double channel_length = 1000.0;
constexpr double channel_width = 20.0;

/// m²/s over the foot of a plane at a time, s: q = α h^(5/3) along the characteristics.
double plane_outflow(double time) {
    const double alpha = std::sqrt(0.05) / 0.015;
    const double most = rain * plane_length;
    if (time <= rainy) return std::min(alpha * std::pow(rain * time, 5.0 / 3.0), most);
    double low = 0.0;
    double high = most;
    for (int round = 0; round < 60; ++round) {
        const double q = 0.5 * (low + high);
        const double way =
            q / rain + 5.0 / 3.0 * std::pow(alpha, 0.6) * std::pow(q, 0.4) * (time - rainy);
        (way > plane_length ? high : low) = q;
    }
    return 0.5 * (low + high);
}

/// m³/s out of the channel, whose area A grows along each characteristic by what has come in from
/// the sides since that left the head, or since the start.
class KinematicChannel {
  public:
    KinematicChannel() {
        came_.push_back(0.0);
        for (double time = 0.5 * dt; time < 10800.0; time += dt) {
            const double inflow =
                2.0 * plane_outflow(time) + (time < rainy ? rain * channel_width : 0.0);
            came_.push_back(came_.back() + dt * inflow);
        }
    }

    [[nodiscard]] double outflow(double time) const {
        const auto now = static_cast<std::size_t>(std::lround(time / dt));
        std::size_t low = 0;
        std::size_t high = now;
        if (way(0, now) > channel_length) {
            while (high - low > 1) {
                const std::size_t middle = (low + high) / 2;
                (way(middle, now) > channel_length ? low : high) = middle;
            }
        }
        return alpha * std::pow(came_[now] - came_[low], 5.0 / 3.0);
    }

  private:
    [[nodiscard]] double way(std::size_t from, std::size_t until) const {
        double sum = 0.0;
        for (std::size_t k = from; k <= until; ++k)
            sum += dt * 5.0 / 3.0 * alpha * std::pow(came_[k] - came_[from], 2.0 / 3.0);
        return sum;
    }

    static constexpr double dt = 5.0;
    const double alpha = std::sqrt(0.02) / (0.15 * std::pow(channel_width, 2.0 / 3.0));
    std::vector<double> came_;  // m² since the start
};

TEST(TiltedV, HydrographsAreThoseOfTheKinematicWave) {
    constexpr double dx = 20.0;
    constexpr double dy = 50.0;
    constexpr int nx = 81;
    constexpr int ny = 20;
    Grid bed(nx, ny);
    Grid roughness(nx, ny, 0.015);
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x) bed(x, y) = 21.0 + 0.05 * (std::abs(x - 40) * dx - 10.0);
        bed(40, y) = 0.02 * (y + 0.5) * dy;
        roughness(40, y) = 0.15;
    }
    WaterParameters water;
    water.friction = FrictionLaw::manning;
    water.edges_x = water.edges_y = EdgeKind::wall;
    water.rain = 10.8;
    water.rain_until = rainy;
    water.time_step = 60.0;
    EdgeSettings outlet = edge(GridSide::south, EdgeFlow::open);
    outlet.from = 800.0;
    outlet.to = 820.0;
    water.edges = {outlet};
    MapSettings map;
    map.quantity = MapQuantity::roughness;
    water.maps = {map};
    const auto gauge = [](const char* name, double at_x, double at_y, double to_x, double to_y) {
        GaugeSettings settings;
        settings.name = name;
        settings.at = {at_x, at_y};
        settings.to = {to_x, to_y};
        return settings;
    };
    water.gauges = {gauge("outlet", 820.0, 0.0, 800.0, 0.0),
                    gauge("west", 800.0, 1000.0, 800.0, 0.0),
                    gauge("east", 820.0, 0.0, 820.0, 1000.0)};
    WorkerPool pool(2);
    ModelSetup setup{bed, {}, {dx, dy, 1.0, true}, 1, pool, true};
    CellMap cells;
    cells.values = roughness;
    setup.maps = {cells};
    Gully gully(water, std::move(setup));
    const auto number = [&](const std::string& name) {
        for (const SnapshotNumber& one : gully.snapshot().numbers) {
            if (one.name == name) return one.value;
        }
        return std::nan("");
    };
    const KinematicChannel channel;
    double most = 0.0;
    while (gully.time() < 10800.0) {
        gully.step();
        most = std::max(most, number("outlet_discharge_m3s"));
        if (std::fmod(gully.time(), 900.0) != 0.0) continue;
        SCOPED_TRACE(gully.time());
        const double middle = gully.time() - 30.0;  // the gauges read the mean of a step
        EXPECT_NEAR(number("west_discharge_m3s"), 1000.0 * plane_outflow(middle), 0.05);
        EXPECT_NEAR(number("east_discharge_m3s"), number("west_discharge_m3s"), 1e-9);
        EXPECT_NEAR(number("outlet_discharge_m3s"), channel.outflow(middle), 0.2);
        if (gully.time() == 3600.0) {
            EXPECT_NEAR(number("outlet_discharge_m3s"), 4.86, 0.02);
        }
    }
    EXPECT_NEAR(most, 4.86, 0.005);
    const double fallen = rain * rainy * 1620.0 * 1000.0;
    EXPECT_NEAR(number("outlet_volume_m3") + number("water_volume"), fallen, 1e-12 * fallen);
    EXPECT_NEAR(number("outlet_volume_m3"), number("left_volume"), 1e-12 * fallen);
}

/// The table beside the scene.
TEST(TiltedV, TheSceneShipsTheKinematicWave) {
    std::ifstream file(FUMON_SCENES_FOLDER "/examinations/tilted-v.csv");
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    const Table table = parse_csv_table({"tilted-v.csv", text});
    ASSERT_EQ(table.rows(), 61U);
    const KinematicChannel channel;
    for (std::size_t row = 5; row < table.rows(); row += 5) {
        const double time = table.columns[0].values[row];
        EXPECT_NEAR(table.columns[1].values[row], 1000.0 * plane_outflow(time), 2e-4);
        EXPECT_NEAR(table.columns[2].values[row], channel.outflow(time), 0.02);
    }
}

}  // namespace
}  // namespace tilted_v
}  // namespace fumon::test
