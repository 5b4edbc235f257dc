#include "models/air/grain_flight.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/worker_pool.h"
#include "models/air/grain_drag.h"
#include "support/couette_section.h"
#include "vectors/target.h"

namespace fumon::test {
namespace {

constexpr double millimetre = 1e-3;
constexpr double gravity = 9.8;

/// Appendix B of Terada (2025): table 3's box with a flat bed at 2·h0, so a gap of 1 mm.
constexpr double bed_height = 0.5 * millimetre;
constexpr double gap = 1.0 * millimetre;

SnapshotSection appendix_b() {
    return couette_section(1200, 61, 0.025 * millimetre, 1.0, [](double) { return bed_height; });
}

/// Eqs. B6 and B8: where a grain is after t seconds, from (0, 0) at friction speed.
struct ClosedForm {
    double angle;                                                          // degrees
    double relaxation = 2650.0 * 0.3e-3 * 0.3e-3 / (18.0 * 1.3 * 1.5e-5);  // m/C, s
    double shear = 1.0 / gap;
    double speed = std::sqrt(1.5e-5 * shear);

    [[nodiscard]] double sine() const { return std::sin(angle * std::numbers::pi / 180.0); }
    [[nodiscard]] double cosine() const { return std::cos(angle * std::numbers::pi / 180.0); }
    [[nodiscard]] double z(double t) const {
        const double fall = relaxation * gravity;
        return relaxation * (speed * sine() + fall) * -std::expm1(-t / relaxation) - fall * t;
    }
    [[nodiscard]] double x(double t) const {
        const double decay = std::exp(-t / relaxation);
        const double up = speed * sine();
        const double m = relaxation;
        return m * (speed * cosine() - shear * m * (2.0 * up + 3.0 * m * gravity)) * (1.0 - decay) +
               shear * m * up * t * (1.0 + decay) + shear * m * m * gravity * t * (2.0 + decay) -
               0.5 * shear * m * gravity * t * t;
    }
    [[nodiscard]] double flight_time() const {
        double low = 1e-4;
        double high = 1.0;
        for (int k = 0; k < 200; ++k) {
            const double middle = 0.5 * (low + high);
            (z(middle) > 0.0 ? low : high) = middle;
        }
        return low;
    }
};

TEST(GrainFlight, FollowsTheClosedFormOverAFlatBed) {
    const SnapshotSection section = appendix_b();
    WorkerPool pool(1);
    const GrainFlights flights(section, {}, {}, pool);
    const double published[][2] = {{20.0, 0.9788}, {40.0, 1.5231}, {60.0, 1.4260}};
    for (const auto& [angle, length] : published) {
        const ClosedForm exact{angle};
        const double time = exact.flight_time();
        EXPECT_NEAR(exact.x(time) / millimetre, length, 5e-5);
        const Launch launch{0.0, angle};
        const Flight flight = flights.fly({&launch, 1}).front();
        // Euler's parabola is one step longer, and the landing is found up to one step late
        EXPECT_GE(flight.time, time) << angle;
        EXPECT_LE(flight.time, time + 2e-5) << angle;
        const double way_of_two_steps = exact.x(time + 2e-5) - exact.x(time);
        EXPECT_GT(flight.length, exact.x(time)) << angle;
        EXPECT_LT(flight.length, exact.x(time) + 1.01 * way_of_two_steps) << angle;
        EXPECT_DOUBLE_EQ(flight.height, bed_height);
        EXPECT_EQ(flight.slope, 0.0);
    }
}

TEST(GrainFlight, EulersErrorIsOfFirstOrder) {
    const SnapshotSection section = appendix_b();
    WorkerPool pool(1);
    const ClosedForm exact{40.0};
    const double length = exact.x(exact.flight_time());
    const Launch launch{0.0, 40.0};
    const auto off = [&](double step) {
        FlightParameters parameters;
        parameters.flight_time_step = step;
        const GrainFlights flights(section, parameters, {}, pool);
        return std::fabs(flights.fly({&launch, 1}).front().length / length - 1.0);
    };
    EXPECT_LT(off(1e-6), 2.5e-4);
    EXPECT_LT(off(1e-7), 2.5e-5);
}

TEST(GrainFlight, WithoutDragItIsAThrow) {
    const SnapshotSection section = appendix_b();
    WorkerPool pool(1);
    FlightParameters parameters;
    parameters.grain_density = 30000.0;
    parameters.grain_diameter = 10.0;
    parameters.flight_time_step = 1e-7;
    const GrainFlights flights(section, parameters, {}, pool);
    const double squared_speed = 1.5e-5 / gap;
    for (const double angle : {10.0, 45.0, 80.0, 120.0}) {
        const Launch launch{2.0 * millimetre, angle};
        const Flight flight = flights.fly({&launch, 1}).front();
        const double expected =
            squared_speed * std::sin(2.0 * angle * std::numbers::pi / 180.0) / gravity;
        EXPECT_NEAR(flight.length / expected, 1.0, 1e-3) << angle;
    }
}

TEST(GrainFlight, EnergyIsKeptInStillAirAndLostToDrag) {
    SnapshotSection section = appendix_b();
    section.fields[0].values = Grid(1200, 61);
    WorkerPool pool(1);
    const auto landing_speed = [&](double density) {
        FlightParameters parameters;
        parameters.grain_density = density;
        parameters.flight_time_step = 1e-7;
        const GrainFlights flights(section, parameters, {}, pool);
        const GrainPath path = flights.path({0.0, 50.0});
        const std::size_t last = path.x.size() - 1;
        return std::hypot(path.x[last] - path.x[last - 1], path.z[last] - path.z[last - 1]) /
               parameters.flight_time_step;
    };
    const double launched = std::sqrt(1.5e-5 / gap);
    EXPECT_NEAR(landing_speed(30000.0) / launched, 1.0, 5e-3);
    EXPECT_LT(landing_speed(300.0), 0.9 * launched);
}

TEST(GrainFlight, LaunchesAtTheAngleToTheLocalBed) {
    const double slope = 0.2;
    SnapshotSection section = couette_section(100, 61, 0.025 * millimetre, 1.0, [&](double x) {
        return 0.5 * millimetre - slope * std::fabs(x - 1.25 * millimetre);
    });
    WorkerPool pool(1);
    const GrainFlights flights(section, {}, {}, pool);
    const GrainPath up = flights.path({0.5 * millimetre, 30.0});
    const GrainPath down = flights.path({2.0 * millimetre, 30.0});
    const auto angle = [](const GrainPath& path) {
        return std::atan2(path.z[1] - path.z[0], path.x[1] - path.x[0]) * 180.0 / std::numbers::pi;
    };
    const double turn = std::atan(slope) * 180.0 / std::numbers::pi;
    EXPECT_NEAR(angle(up), 30.0 + turn, 1e-6);
    EXPECT_NEAR(angle(down), 30.0 - turn, 1e-6);
}

TEST(GrainFlight, GoesRoundThePeriodicSection) {
    // the same flat air, once in a box longer than any flight and once in one of eight columns
    WorkerPool pool(1);
    const auto flat = [](double) { return bed_height; };
    const SnapshotSection wide = couette_section(200, 61, 0.025 * millimetre, 1.0, flat);
    const SnapshotSection narrow = couette_section(8, 61, 0.025 * millimetre, 1.0, flat);
    const Launch launch{0.0, 40.0};
    const Flight long_way = GrainFlights(wide, {}, {}, pool).fly({&launch, 1}).front();
    const Flight round = GrainFlights(narrow, {}, {}, pool).fly({&launch, 1}).front();
    EXPECT_GT(round.length, 7 * 8 * 0.025 * millimetre);
    EXPECT_NEAR(round.length, long_way.length, 1e-12);
    EXPECT_EQ(round.time, long_way.time);
}

TEST(GrainFlight, ItsPathEndsWhereItsFlightDoes) {
    const SnapshotSection section = couette_section(400, 61, 0.025 * millimetre, 1.0, [](double x) {
        return 0.25 * millimetre * (1.0 + std::cos(628.3185307179586 * x));
    });
    WorkerPool pool(1);
    for (const GrainDrag drag : {GrainDrag::stokes, GrainDrag::schiller_naumann}) {
        FlightParameters parameters;
        parameters.drag = drag;
        const GrainFlights flights(section, parameters, {}, pool);
        const Launch launch{9.9 * millimetre, 40.0};
        const Flight flight = flights.fly({&launch, 1}).front();
        const GrainPath path = flights.path(launch);
        EXPECT_EQ(path.x.back() - path.x.front(), flight.length);
        EXPECT_EQ(path.z.front(), flight.height);
        EXPECT_NEAR(1e-5 * static_cast<double>(path.x.size() - 1), flight.time, 1e-9);
        EXPECT_GT(path.x.back(), 400 * 0.025 * millimetre) << "past the section's end";
    }
}

TEST(GrainFlight, BeyondStokesGrainsRiseLessAndGoFaster) {
    const SnapshotSection section = appendix_b();
    WorkerPool pool(1);
    FlightParameters parameters;
    const Launch launch{0.0, 40.0};
    const Flight stokes = GrainFlights(section, parameters, {}, pool).fly({&launch, 1}).front();
    parameters.drag = GrainDrag::schiller_naumann;
    const Flight beyond = GrainFlights(section, parameters, {}, pool).fly({&launch, 1}).front();
    EXPECT_LT(beyond.time, stokes.time);
    EXPECT_GT(beyond.length / beyond.time, 1.005 * stokes.length / stokes.time);
    EXPECT_GT(stokes.reynolds, std::sqrt(1.5e-5 / gap) * 0.3e-3 / 1.5e-5) << "that of its launch";
    EXPECT_LT(stokes.reynolds, 1.0 * 0.3e-3 / 1.5e-5) << "that of the lid's speed";
}

TEST(GrainFlight, SuccessiveHopsAddUp) {
    const SnapshotSection section = couette_section(400, 61, 0.025 * millimetre, 1.0, [](double x) {
        return 0.25 * millimetre * (1.0 + std::cos(628.3185307179586 * x));
    });
    WorkerPool pool(2);
    const GrainFlights flights(section, {}, {}, pool);
    const std::vector<double> angles{20.0};
    const std::vector<Launch> launches = flights.every_column(angles);
    const std::vector<Flight> three = flights.in_succession(launches, 3);
    for (const std::size_t n : {0U, 57U, 399U}) {
        Launch launch = launches[n];
        double length = 0.0;
        for (int hop = 0; hop < 3; ++hop) {
            const Flight one = flights.fly({&launch, 1}).front();
            length += one.length;
            launch.x = one.x + one.length;
        }
        EXPECT_NEAR(three[n].length, length, 1e-12);
        EXPECT_EQ(three[n].height, flights.fly({&launches[n], 1}).front().height);
    }
}

void expect_same(const std::vector<Flight>& found, const std::vector<Flight>& expected) {
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t n = 0; n < expected.size(); ++n) {
        ASSERT_EQ(found[n].length, expected[n].length) << "launch " << n;
        ASSERT_EQ(found[n].time, expected[n].time);
        ASSERT_EQ(found[n].reynolds, expected[n].reynolds);
    }
}

TEST(GrainFlight, SameBytesAtAnyNumberOfThreadsAndOnEveryTarget) {
    const SnapshotSection section = couette_section(400, 61, 0.025 * millimetre, 1.0, [](double x) {
        return 0.25 * millimetre * (1.0 + std::cos(628.3185307179586 * x));
    });
    for (const GrainDrag drag : {GrainDrag::stokes, GrainDrag::schiller_naumann}) {
        FlightParameters parameters;
        parameters.drag = drag;
        WorkerPool alone(1);
        const GrainFlights one(section, parameters, {}, alone);
        const std::vector<Launch> launches = one.every_column(parameters.launch_angles);
        const std::vector<Flight> expected = one.fly(launches);
        ASSERT_EQ(expected.size(), 1600U);
        for (const int threads : {2, 3, 7}) {
            SCOPED_TRACE(threads);
            WorkerPool pool(threads);
            expect_same(GrainFlights(section, parameters, {}, pool).fly(launches), expected);
        }
        const std::string before = vectors::target();
        for (const std::string& target : vectors::targets()) {
            SCOPED_TRACE(target);
            vectors::use_target(target);
            expect_same(one.fly(launches), expected);
        }
        vectors::use_target(before);
    }
}

std::string flight_refusal(const std::function<void()>& work) {
    try {
        work();
    } catch (const Error& fault) {
        return fault.what();
    }
    return "nothing was refused";
}

TEST(GrainDrag, SchillerAndNaumannsFactor) {
    EXPECT_EQ(drag::schiller_naumann_factor(0.0), 1.0);
    for (const double reynolds : {1e-3, 0.5, 1.0, 2.0, 9.0, 100.0, 800.0}) {
        EXPECT_NEAR(drag::schiller_naumann_factor(reynolds * reynolds),
                    1.0 + 0.15 * std::pow(reynolds, 0.687), 1e-13 * reynolds + 1e-15)
            << reynolds;
    }
    // the standard drag curve of a sphere at Re = 100: a coefficient of 1.09
    EXPECT_NEAR(24.0 / 100.0 * drag::schiller_naumann_factor(1e4), 1.09, 0.01);
    EXPECT_NEAR(drag::stokes_rate(1.3, 1.5e-5, 2650.0, 0.3e-3), 1.4717, 1e-4);
}

TEST(GrainFlight, RefusesGrainsThatDoNotComeDown) {
    WorkerPool pool(2);
    const SnapshotSection windy =
        couette_section(100, 61, 0.025 * millimetre, 1000.0, [](double) { return bed_height; });
    const std::vector<Launch> launches{{0.0, 1.0}, {1.25 * millimetre, 80.0}, {0.0, 70.0}};
    EXPECT_EQ(
        flight_refusal([&] { static_cast<void>(GrainFlights(windy, {}, {}, pool).fly(launches)); }),
        "the grain launched at x = 0.00125 m at 80 degrees leaves through the lid (z = "
        "0.0015 m) after 0.00027 s; raise the lid, or try a smaller model.launch_angles or "
        "slower air");
    SnapshotSection lifting = appendix_b();
    FlightParameters dust;
    dust.grain_diameter = 0.02;
    for (int i = 0; i < 1200; ++i) {
        for (int k = 0; k < 61; ++k)
            lifting.fields[1].values(i, k) = k > 20 ? 0.1 * (1.0 - k / 40.0) : 0.0;
    }
    EXPECT_EQ(
        flight_refusal([&] {
            static_cast<void>(GrainFlights(lifting, dust, {}, pool).fly({launches.data() + 1, 1}));
        }),
        "the grain launched at x = 0.00125 m at 80 degrees is not down after 2 s; try a "
        "larger model.grain_diameter or model.grain_density, or slower air");
}

TEST(GrainFlight, RefusesStepsTooLongForTheDragAndAnglesNamedTwice) {
    WorkerPool pool(1);
    const SnapshotSection section = appendix_b();
    FlightParameters parameters;
    parameters.grain_diameter = 0.001;
    try {
        const GrainFlights flights(section, parameters, {}, pool);
        FAIL() << "a step of 1e-5 s";
    } catch (const KeyError& fault) {
        EXPECT_EQ(fault.key(), "model.flight_time_step");
        EXPECT_STREQ(fault.what(),
                     "grains of 0.001 mm lose their speed against the air in 7.55e-06 s; "
                     "model.flight_time_step = 1e-05 s is too long for them, take at most 3.8e-06");
    }
    parameters = {};
    parameters.launch_angles = {10.0, 20.0, 10.0};
    EXPECT_EQ(flight_refusal([&] { const GrainFlights flights(section, parameters, {}, pool); }),
              "model.launch_angles has 10 degrees twice; name it once");
    SnapshotSection bare = section;
    bare.curves.pop_back();
    EXPECT_EQ(flight_refusal([&] { const GrainFlights flights(bare, {}, {}, pool); }),
              "grains cannot fly in a section without the curve bed_shear_stress");
}

}  // namespace
}  // namespace fumon::test
