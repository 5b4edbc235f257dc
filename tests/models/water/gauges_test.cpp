// Gauges: what they read of water whose depth and speed are known, and where they refuse to stand.

#include "models/water/gauges.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/error.h"
#include "base/find_named.h"
#include "support/temporary_folder.h"

namespace fumon::test {
namespace {

constexpr int nx = 20;
constexpr int ny = 10;

WaterDomain domain_of_gauges() {
    WaterDomain domain;
    domain.dx = 2.0;
    domain.dy = 5.0;
    return domain;
}

GaugeSettings at(std::vector<double> place, std::vector<double> to = {}) {
    GaugeSettings gauge;
    gauge.at = std::move(place);
    gauge.to = std::move(to);
    return gauge;
}

/// What one gauge at a point reads under a column in water half a metre deep that flows at (3, 4)
/// m/s.
double reading(const GaugeSettings& gauge, const std::string& column,
               const WaterDomain& domain = domain_of_gauges()) {
    GullyParameters parameters;
    parameters.gauges = {gauge};
    const WorldScale scale{domain.dx, domain.dy, 1.0, true,
                           GeoReference{500.0, 300.0, 0.2, 0.5, true, ""}};
    const Gauges gauges(parameters, domain, scale, nx, ny);
    const Water water{Grid(nx, ny, 0.5), Grid(nx, ny, 3.0), Grid(nx, ny, 4.0)};
    Grid bed(nx, ny, 100.0);
    bed(6, 3) = 107.0;
    const auto numbers = gauges.read(water, bed);
    const SnapshotNumber* number = find_named(numbers, column);
    return number == nullptr ? -1e300 : number->value;
}

std::string refusal(const std::vector<GaugeSettings>& settings, bool on_map = true) {
    GullyParameters parameters;
    parameters.gauges = settings;
    WorldScale scale{2.0, 5.0, 1.0, true};
    if (on_map) scale.place = GeoReference{500.0, 300.0, 0.2, 0.5, true, ""};
    WaterDomain domain = domain_of_gauges();
    domain.nodata = Mask(nx, ny);
    domain.nodata(0, 0) = 1;
    for (int x = 0; x < nx; ++x) domain.nodata(x, ny - 1) = 1;
    try {
        const Gauges gauges(parameters, domain, scale, nx, ny);
    } catch (const KeyError& error) {
        return error.key();
    }
    return "";
}

TEST(Gauges, APointReadsItsCell) {
    EXPECT_EQ(reading(at({13.9, 15.1}), "gauge_1_depth_m"), 0.5);
    EXPECT_EQ(reading(at({13.9, 15.1}), "gauge_1_level_m"), 107.5);
    EXPECT_EQ(reading(at({14.1, 15.1}), "gauge_1_level_m"), 100.5);
    EXPECT_EQ(reading(at({13.9, 15.1}), "gauge_1_unit_discharge_m2s"), 2.5);
}

TEST(Gauges, StandWhereTheMapSays) {
    GaugeSettings gauge = at({501.3, 301.6});
    gauge.coordinates = GaugeCoordinates::map;
    gauge.name = "bridge";
    EXPECT_EQ(reading(gauge, "bridge_level_m"), 107.5);
}

/// What a grid of 3 by 100 cells says to a line up to its northern edge, or along that.
std::string of_northern_edge(GaugeSettings line, double dy, double south) {
    GullyParameters parameters;
    parameters.gauges = {std::move(line)};
    WorldScale scale{2.0, dy, 1.0, true};
    scale.place = GeoReference{500.0, south, 2.0, dy, true, ""};
    WaterDomain domain = domain_of_gauges();
    domain.dy = dy;
    return message_of<KeyError>([&] { Gauges(parameters, domain, scale, 3, 100); });
}

TEST(Gauges, LinesMayEndOnTheNorthernEdge) {
    ASSERT_LT(0.57 * 100, 57.0) << "rounded";
    for (const bool swapped : {false, true}) {
        const auto line = [&](std::vector<double> from, std::vector<double> to) {
            return swapped ? at(std::move(to), std::move(from))
                           : at(std::move(from), std::move(to));
        };
        EXPECT_EQ(of_northern_edge(line({2.0, 0.0}, {2.0, 57.0}), 0.57, 0.0), "");
        EXPECT_EQ(of_northern_edge(line({0.0, 57.0}, {6.0, 57.0}), 0.57, 0.0), "");
        EXPECT_EQ(of_northern_edge(line({2.0, 0.0}, {4.0, 500.0}), 5.0, 0.0), "");
        GaugeSettings on_map = line({502.0, 4000123.4}, {502.0, 4000180.4});
        on_map.coordinates = GaugeCoordinates::map;
        EXPECT_EQ(of_northern_edge(on_map, 0.57, 4000123.4), "");
        EXPECT_NE(of_northern_edge(line({2.0, 0.0}, {2.0, 57.01}), 0.57, 0.0), "") << "beyond it";
    }
}

TEST(Gauges, RefuseToStandNowhere) {
    EXPECT_EQ(refusal({at({1.0, 6.0})}), "");
    EXPECT_EQ(refusal({at({40.0, 6.0})}), "gauge.0.at");
    EXPECT_EQ(refusal({at({1.0})}), "gauge.0.at");
    EXPECT_EQ(refusal({at({1.0, 1.0})}), "gauge.0.at");  // no data
    EXPECT_EQ(refusal({at({1.0, 6.0}, {1.0, 6.0})}), "gauge.0.to");
    EXPECT_EQ(refusal({at({1.0, 50.0}, {39.0, 50.0})}), "gauge.0.to");  // no data
    EXPECT_EQ(refusal({at({1.0, 6.0}, {41.0, 6.0})}), "gauge.0.to");    // beyond the grid
    EXPECT_EQ(refusal({at({40.0, 0.0}, {40.0, 50.0})}), "");            // its eastern side
    EXPECT_EQ(refusal({GaugeSettings{}}), "gauge.0.at");
    GaugeSettings named = at({1.0, 6.0});
    named.name = "2 rivers";
    EXPECT_EQ(refusal({named}), "gauge.0.name");
    named.name = "river";
    EXPECT_EQ(refusal({named, named}), "gauge.1.name");
    named.coordinates = GaugeCoordinates::map;
    EXPECT_EQ(refusal({named}, false), "gauge.0.coordinates");
    named.side = GaugeSide::west;
    EXPECT_EQ(refusal({named}), "gauge.0.side");
    GaugeSettings side;
    side.side = GaugeSide::west;
    EXPECT_EQ(refusal({side}), "");
    side.side = GaugeSide::north;
    EXPECT_EQ(refusal({side}), "gauge.0.side");  // no data
    side.side = GaugeSide::all;
    EXPECT_EQ(refusal({side}), "");
}

}  // namespace
}  // namespace fumon::test
