// fumon's finite volumes beside exact solutions (tests/examination).

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/worker_pool.h"
#include "examination/water_cases.h"
#include "models/registry.h"
#include "models/water/finite_volume_scheme.h"
#include "scene/initial_bed.h"
#include "scene/input_maps.h"
#include "scene/read.h"

namespace fumon::examination {
namespace {

/// What is asked of a case on 100 and 200 cells: the error of depth over volume, the order of it,
/// and that away from shores and kinks.
struct Asked {
    const char* name;
    double error;  ///< on 200 cells
    double order;
    double order_away;
    std::optional<ShoreCells> shore_cells{};  ///< other than the case's
};

const std::vector<Asked> asked{
    {"bump-subcritical", 3e-5, 1.7, 1.7},
    {"bump-transcritical", 2.0e-4, 1.9, 1.75},
    {"bump-jump", 1.8e-3, 1.0, 1.1},
    {"channel-subcritical", 3e-5, 1.9, 1.9},
    {"channel-supercritical", 4e-5, 1.7, 1.7},
    {"channel-transcritical", 1.2e-5, 1.7, 1.7},
    {"channel-jump", 4e-4, 1.4, 1.7},
    {"channel-rain-subcritical", 3e-5, 1.9, 1.9},
    {"channel-rain-supercritical", 5e-5, 1.7, 1.7},
    {"dam-wet", 3.5e-3, 0.9, 0.9},
    {"dam-dry", 3.5e-3, 0.9, 0.9},
    {"dam-friction", 1.3e-3, 0.9, 0.9},
    {"thacker-parabola", 1e-5, 1.9, 1.2},
    {"thacker-planar", 1.7e-5, 2.5, 2.0},
    {"thacker-radial", 4.5e-5, 2.1, 1.75},
    {"thacker-parabola", 7e-4, 1.7, 1.05, ShoreCells::partly_wet},
    {"thacker-planar", 6.5e-4, 1.75, 1.1, ShoreCells::partly_wet},
    {"thacker-radial", 1.25e-3, 1.45, 0.6, ShoreCells::partly_wet},
    {"thacker-parabola", 8.5e-3, 1.85, 1.4, ShoreCells::whole},
    {"thacker-planar", 5.5e-3, 1.4, 0.8, ShoreCells::whole},
    {"thacker-radial", 1.15e-2, 1.4, 0.75, ShoreCells::whole},
};

const Case& case_of(const std::string& name) {
    static const std::vector<Case> cases = all_cases();
    for (const Case& one : cases) {
        if (one.name == name) return one;
    }
    throw std::logic_error("no case " + name);
}

class ExactFlow : public ::testing::TestWithParam<Asked> {};

TEST_P(ExactFlow, IsMet) {
    Case one = case_of(GetParam().name);
    if (GetParam().shore_cells) {
        one.parameters.shore_cells = *GetParam().shore_cells;
        one.parameters.shore_velocity = ShoreVelocity::even;
    }
    const Outcome coarse = run_case(one, 100, 1);
    const Outcome fine = run_case(one, 200, 1);
    EXPECT_LT(fine.errors.depth, GetParam().error);
    EXPECT_GT(std::log2(coarse.errors.depth / fine.errors.depth), GetParam().order);
    EXPECT_GT(std::log2(coarse.errors.away / fine.errors.away), GetParam().order_away);
    EXPECT_LT(coarse.errors.mass, 1e-13);
    EXPECT_LT(fine.errors.mass, 1e-13);
}

INSTANTIATE_TEST_SUITE_P(Cases, ExactFlow, ::testing::ValuesIn(asked), [](const auto& each) {
    std::string name = each.param.name;
    std::erase(name, '-');
    if (!each.param.shore_cells) return name;
    return name + (*each.param.shore_cells == ShoreCells::whole ? "_with_whole_cells"
                                                                : "_with_partly_wet_cells");
});

TEST(ExactLake, StaysAtRestOverABumpUnderAndAboveIt) {
    for (const char* name : {"lake-immersed-bump", "lake-emerged-bump"}) {
        Case one = case_of(name);
        for (const auto& [velocity, cells] : {std::pair{ShoreVelocity::sloped, ShoreCells::whole},
                                              {ShoreVelocity::even, ShoreCells::whole},
                                              {ShoreVelocity::even, ShoreCells::partly_wet},
                                              {ShoreVelocity::sloped, ShoreCells::planes}}) {
            one.parameters.shore_velocity = velocity;
            one.parameters.shore_cells = cells;
            const Outcome outcome = run_case(one, 100, 1);
            EXPECT_LT(outcome.errors.speed, 1e-12) << name;
            EXPECT_LT(outcome.errors.mass, 1e-13) << name;
            if (cells == ShoreCells::planes) continue;  // whose depths are means
            EXPECT_LT(outcome.errors.depth, 1e-13) << name;
        }
    }
}

/// What the scheme's former rule costs, which older scenes keep.
TEST(MovingShore, KeepsItsMomentumOnASlopeThatTheGridResolves) {
    Case one = case_of("thacker-planar");
    one.parameters.shore_cells = ShoreCells::whole;
    one.parameters.shore_velocity = ShoreVelocity::even;
    EXPECT_LT(run_case(one, 100, 1).errors.depth, 0.02);
    one.parameters.stopping_steps = StoppingSteps::all;
    EXPECT_GT(run_case(one, 100, 1).errors.depth, 0.04);
}

TEST(MovingShore, ADeepFlowLosesNothingAtTheFootOfABump) {
    Case one = case_of("bump-subcritical");
    EXPECT_LT(run_case(one, 50, 1).errors.depth, 1e-3);
    one.parameters.stopping_steps = StoppingSteps::all;
    EXPECT_GT(run_case(one, 50, 1).errors.depth, 2e-3);
}

TEST(LimiterTolerance, RidsCalmFlowOfStandingRipples) {
    Case one = case_of("channel-subcritical");
    EXPECT_LT(run_case(one, 200, 1).errors.depth, 3e-5);
    one.parameters.limiter_tolerance = 0.0;
    EXPECT_GT(run_case(one, 200, 1).errors.depth, 8e-5);
}

/// A jump that stands still sends no waves where slopes are less steep.
TEST(LimiterSteepness, QuietsAStandingJump) {
    Case one = case_of("bump-jump");
    EXPECT_LT(run_case(one, 100, 1).errors.depth, 4e-3);
    one.parameters.limiter_steepness = 2.0;
    EXPECT_GT(run_case(one, 100, 1).errors.depth, 5.5e-3);
}

TEST(ShoreVelocity, EvenSendsFewerWavesFromAShoreOverASmoothBed) {
    Case one = case_of("thacker-radial");
    one.parameters.shore_cells = ShoreCells::whole;
    one.parameters.shore_velocity = ShoreVelocity::even;
    EXPECT_LT(run_case(one, 100, 1).errors.depth, 3.3e-2);
    one.parameters.shore_velocity = ShoreVelocity::sloped;
    EXPECT_GT(run_case(one, 100, 1).errors.depth, 3.9e-2);
}

TEST(ShoreCells, PartlyWetOnesKeepAMovingShoreSharp) {
    Case one = case_of("thacker-planar");
    one.parameters.shore_velocity = ShoreVelocity::even;
    one.parameters.shore_cells = ShoreCells::partly_wet;
    EXPECT_LT(run_case(one, 100, 1).errors.depth, 2.3e-3);
    one.parameters.shore_cells = ShoreCells::whole;
    one.parameters.shore_velocity = ShoreVelocity::even;
    EXPECT_GT(run_case(one, 100, 1).errors.depth, 1.4e-2);
}

/// What happens at the shore spoils the lake inside no more.
TEST(ShoreCells, PlanesOfTheDeeperWaterSendFewWaves) {
    Case one = case_of("thacker-radial");
    EXPECT_LT(run_case(one, 100, 1).errors.away, 8.5e-5);
    one.parameters.shore_cells = ShoreCells::partly_wet;
    one.parameters.shore_velocity = ShoreVelocity::even;
    EXPECT_GT(run_case(one, 100, 1).errors.away, 4e-4);
}

/// The parabola's shore on fine grids, where waves from films behind it would outdo other errors.
TEST(ShoreCells, PlanesAreOfSecondOrderOnFineGridsToo) {
    Case one = case_of("thacker-parabola");
    one.duration /= 5.0;  // a period
    const Outcome coarse = run_case(one, 400, 1);
    const Outcome fine = run_case(one, 800, 1);
    EXPECT_GT(std::log2(coarse.errors.depth / fine.errors.depth), 1.85);
    EXPECT_GT(std::log2(coarse.errors.away / fine.errors.away), 1.75);
}

TEST(ShoreCells, NoFilmStaysBehindAFallingShore) {
    Case one = case_of("thacker-parabola");
    one.duration /= 20.0;  // when it falls fastest, on one side
    constexpr int cells = 200;
    Setting setting = setting_of(one, cells);
    WorkerPool pool(1);
    FiniteVolumeScheme scheme(setting.parameters, setting.domain, pool);
    scheme.convert_to_means(setting.water, setting.bed);
    double before = 0.0;
    for (const double depth : setting.water.depth.values()) before += depth;
    double step = scheme.step_at_courant_one(setting.water);
    for (double time = 0.0; time < one.duration;) {
        const double dt = std::min(0.4 * step, one.duration - time);
        step = scheme.advance(setting.water, setting.bed, dt, 0.0);
        EXPECT_EQ(step, scheme.step_at_courant_one(setting.water)) << time;
        time += dt;
    }
    const auto is_wet = [&](int x) {
        const double middle = one.west + (x + 0.5) * setting.domain.dx;
        return one.exact(middle, 0.0, one.duration).depth > 0.0;
    };
    int behind = 0;
    double after = 0.0;
    for (int y = 0; y < strip_rows; ++y) {
        for (int x = 0; x < cells; ++x) {
            after += setting.water.depth(x, y);
            if (x + 2 >= cells / 2 || is_wet(x + 2)) continue;
            ++behind;
            EXPECT_LT(setting.water.depth(x, y), 1e-9) << x;
        }
    }
    EXPECT_GT(behind, 100);
    EXPECT_NEAR(after, before, 1e-13 * before);
}

/// … nor is it taken away unseen by what the water carries.
TEST(ShoreCells, FlowsThroughFacesAreAllThatMovesTheWater) {
    const Case& one = case_of("thacker-planar");
    constexpr int cells = 40;
    Setting setting = setting_of(one, cells);
    WorkerPool pool(1);
    FiniteVolumeScheme scheme(setting.parameters, setting.domain, pool);
    scheme.convert_to_means(setting.water, setting.bed);
    FaceFlows flows(cells, cells);
    scheme.record(flows);
    for (int step = 0; step < 200; ++step) {
        const Grid before = setting.water.depth;
        const double dt = 0.4 * scheme.step_at_courant_one(setting.water);
        scheme.advance(setting.water, setting.bed, dt, 0.0);
        const double half = 0.5 * dt / setting.domain.dx;
        for (int y = 0; y < cells; ++y) {
            for (int x = 0; x < cells; ++x) {
                double out = 0.0;
                for (const FaceFlows::Stage& stage : flows.stages) {
                    out += half * ((stage.east(x + 1, y) - stage.east(x, y)) +
                                   (stage.north(x, y + 1) - stage.north(x, y)));
                }
                ASSERT_NEAR(setting.water.depth(x, y), before(x, y) - out, 1e-15)
                    << x << ' ' << y << ' ' << step;
            }
        }
    }
}

/// A lake in a bowl off the grid's middle. (Mirror images differ in the last bits where a film
/// gives all its water, as with partly wet cells.)
TEST(ShoreCells, PlanesAreTheSameForMirrorImagesExchangedAxesAndAnyThreads) {
    constexpr int n = 48;
    GullyParameters parameters;
    parameters.friction_coefficient = 0.0;
    parameters.shore_cells = ShoreCells::planes;
    WaterDomain domain;
    domain.edges_x = domain.edges_y = EdgeKind::wall;
    const auto flow = [&](bool mirrored, bool exchanged, int threads) {
        Water water{Grid(n, n), Grid(n, n), Grid(n, n)};
        Grid bed(n, n);
        for (int y = 0; y < n; ++y) {
            for (int x = 0; x < n; ++x) {
                const int to_x = mirrored ? n - 1 - x : exchanged ? y : x;
                const int to_y = exchanged ? x : y;
                const double r2 = 1.3 * (x - 20) * (x - 20) + 0.8 * (y - 25) * (y - 25);
                bed(to_x, to_y) = 0.01 * r2;
                const double depth = 0.05 * (x - 20) + 0.08 * (y - 25) + 1.5 - 0.01 * r2;
                water.depth(to_x, to_y) = depth > 0.0 ? depth : 0.0;
            }
        }
        WorkerPool pool(threads);
        FiniteVolumeScheme scheme(parameters, domain, pool);
        scheme.convert_to_means(water, bed);
        for (int step = 0; step < 150; ++step) scheme.advance(water, bed, 0.05, 0.0);
        return water;
    };
    const Water plain = flow(false, false, 1);
    const Water mirror = flow(true, false, 1);
    const Water exchange = flow(false, true, 1);
    const Water shared = flow(false, false, 3);
    EXPECT_EQ(plain.depth, shared.depth);
    EXPECT_EQ(plain.velocity_x, shared.velocity_x);
    double fastest = 0.0;
    for (int y = 0; y < n; ++y) {
        for (int x = 0; x < n; ++x) {
            fastest = std::max(fastest, std::fabs(plain.velocity_x(x, y)));
            ASSERT_NEAR(plain.depth(x, y), mirror.depth(n - 1 - x, y), 1e-9) << x << ' ' << y;
            ASSERT_NEAR(plain.depth(x, y), exchange.depth(y, x), 1e-9) << x << ' ' << y;
        }
    }
    EXPECT_GT(fastest, 0.3);
}

TEST(PlainFirstOrder, IsFarFromTheExactFlow) {
    const Case& one = case_of("channel-subcritical");
    const Outcome coarse = run_plainly(one, 50);
    const Outcome fine = run_plainly(one, 100);
    const double order = std::log2(coarse.errors.depth / fine.errors.depth);
    EXPECT_GT(order, 0.8);
    EXPECT_LT(order, 1.2);
    EXPECT_GT(fine.errors.depth, 20.0 * run_case(one, 100, 1).errors.depth);
}

std::string text_of(const std::filesystem::path& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// The scenes that ship are those of the cases, and one run as a scene comes to the same end.
TEST(ExaminationScenes, AreWrittenFromTheCases) {
    const std::filesystem::path folder = FUMON_SCENES_FOLDER "/examinations";
    int scenes = 0;
    for (const Case& one : all_cases()) {
        ++scenes;
        const int cells = cells_of_scene(one);
        EXPECT_EQ(text_of(folder / (one.name + ".toml")), scene_of(one, cells)) << one.name;
        EXPECT_EQ(text_of(folder / (one.name + ".asc")), bed_of(one, cells)) << one.name;
        EXPECT_EQ(text_of(folder / (one.name + "-depth.asc")), depth_of(one, cells)) << one.name;
        EXPECT_EQ(text_of(folder / (one.name + "-velocity_y.asc")), velocity_of(one, cells))
            << one.name;
        EXPECT_EQ(text_of(folder / (one.name + ".csv")), curve_of(one, 200)) << one.name;
    }
    EXPECT_EQ(scenes, 17);
}

TEST(ExaminationScenes, RunToTheExactFlow) {
    const std::filesystem::path folder = FUMON_SCENES_FOLDER "/examinations";
    for (const char* name :
         {"channel-rain-supercritical", "dam-wet", "dam-friction", "thacker-planar"}) {
        const Case& one = case_of(name);
        const Scene scene = read_scene(folder / (one.name + ".toml"), {});
        InitialBed initial = make_initial_bed(scene);
        add_maps(scene, initial);
        const int cells = cells_of_scene(one);
        WorkerPool pool(1);
        const auto model = find_model(scene.model.name)
                               ->make(scene.model.parameters, {std::move(initial.bed),
                                                               {},
                                                               initial.scale,
                                                               1,
                                                               pool,
                                                               bed_kind(scene) == BedKind::file,
                                                               std::move(initial.maps)});
        while (model->steps_done() < scene.run.steps) model->step();
        EXPECT_NEAR(model->time(), one.duration, 1e-6);
        const Snapshot end = model->snapshot();
        Water water{end.fields[0].values, end.fields[1].values, end.fields[2].values};
        // Its steps are others, which on so few cells matter more where a shore crosses them.
        const double within = one.basin ? 1.2 : 1.05;
        EXPECT_LT(errors_of(one, setting_of(one, cells), water, depths_of(one)).depth,
                  within * run_case(one, cells, 1).errors.depth)
            << name;
    }
}

/// The solutions themselves, by what they must fulfil.
TEST(ExactSolutions, JumpsKeepMomentum) {
    const double place = exact::bump_jump(0.18, 0.33);
    EXPECT_NEAR(place, 11.665, 0.002);  // SWASHES draws it at 11.67 m
    const double before = exact::bump_transcritical(place, 0.18).depth;
    const double after = exact::bump_subcritical(place, 0.18, 0.33).depth;
    const auto momentum = [](double q, double h) {
        return q * q / h + 0.5 * exact::gravity * h * h;
    };
    EXPECT_NEAR(momentum(0.18, before), momentum(0.18, after), 1e-9);
    const exact::Channel channel = exact::channel_with_jump();
    EXPECT_NEAR(momentum(2.0, channel.depth(500.0 - 1e-9)), momentum(2.0, channel.depth(500.0)),
                1e-4);
}

TEST(ExactSolutions, DamBreaksHavePublishedNumbers) {
    const double t = 6.0;
    EXPECT_NEAR(exact::dam_break(0.005, 0.001, 0.6, t).depth, 0.00253936, 1e-8);
    EXPECT_NEAR(exact::dam_break(0.005, 0.001, 0.6, t).u, 0.127280, 1e-6);
    EXPECT_EQ(exact::dam_break(0.005, 0.001, 0.209964 * t, t).depth, 0.001);
    EXPECT_NEAR(exact::dam_break(0.005, 0.0, 0.0, t).depth, 4.0 / 9.0 * 0.005, 1e-12);
    EXPECT_GT(exact::dam_break(0.005, 0.0, 0.4429 * t, t).depth, 0.0);
    EXPECT_EQ(exact::dam_break(0.005, 0.0, 0.4430 * t, t).depth, 0.0);
    EXPECT_NEAR(exact::dressler(6.0, 40.0, -40.0 * std::sqrt(exact::gravity * 6.0), 40.0).depth,
                6.0, 1e-9);
    // Without resistance Dressler's is Ritter's.
    EXPECT_NEAR(exact::dressler(6.0, 1e9, 100.0, 40.0).depth,
                exact::dam_break(6.0, 0.0, 100.0, 40.0).depth, 1e-9);
}

/// ∂h/∂t + ∂(hu)/∂x + ∂(hv)/∂y = 0 by differences.
TEST(ExactSolutions, ThackersKeepTheirVolume) {
    constexpr double d = 1e-5;
    const auto loss = [&](const auto& flow, double x, double y, double t) {
        const auto q = [&](double at_x, double at_y, bool along_x) {
            const exact::Flow f = flow(at_x, at_y, t);
            return f.depth * (along_x ? f.u : f.v);
        };
        return (flow(x, y, t + d).depth - flow(x, y, t - d).depth) / (2.0 * d) +
               (q(x + d, y, true) - q(x - d, y, true)) / (2.0 * d) +
               (q(x, y + d, false) - q(x, y - d, false)) / (2.0 * d);
    };
    const auto planar = [](double x, double y, double t) {
        return exact::thacker_planar(x, y, t, 1.0, 0.1, 0.5);
    };
    const auto radial = [](double x, double y, double t) {
        return exact::thacker_radial(x, y, t, 1.0, 0.1, 0.8);
    };
    const auto parabola = [](double x, double, double t) {
        return exact::thacker_parabola(x, t, 1.0, 0.5);
    };
    EXPECT_NEAR(loss(planar, 0.3, 0.2, 0.4), 0.0, 1e-8);
    EXPECT_NEAR(loss(radial, 0.3, 0.2, 0.4), 0.0, 1e-8);
    EXPECT_NEAR(loss(parabola, -0.3, 0.0, 0.4), 0.0, 1e-8);
    EXPECT_NEAR(exact::thacker_radial(0.7999, 0.0, 0.0, 1.0, 0.1, 0.8).depth, 0.0, 1e-3);
    EXPECT_EQ(exact::thacker_radial(0.8001, 0.0, 0.0, 1.0, 0.1, 0.8).depth, 0.0);
}

}  // namespace
}  // namespace fumon::examination
