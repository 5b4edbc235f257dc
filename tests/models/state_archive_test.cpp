#include <gtest/gtest.h>

#include <bit>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "base/cancellation.h"
#include "base/error.h"
#include "base/stopwatch.h"
#include "base/worker_pool.h"
#include "files/checkpoint.h"
#include "files/hash.h"
#include "models/registry.h"
#include "models/shared/state_hash.h"
#include "scene/initial_bed.h"
#include "scene/read.h"
#include "support/temporary_folder.h"

namespace fumon::test {
namespace {

/// A model of a scene's text with its threads.
struct Built {
    explicit Built(const std::string& text, int threads) : pool(threads) {
        const Scene scene = parse_scene("run.steps = 1000\n" + text, "scene.toml", "");
        InitialBed initial = make_initial_bed(scene);
        model = find_model(scene.model.name)
                    ->make(scene.model.parameters,
                           {std::move(initial.bed), std::move(initial.nodata), initial.scale,
                            static_cast<std::uint64_t>(scene.seed), pool, false});
    }
    void to(std::int64_t step) const {
        while (model->steps_done() < step) model->step();
    }
    WorkerPool pool;
    std::unique_ptr<Model> model;
};

std::vector<std::uint64_t> bits(std::span<const double> values) {
    std::vector<std::uint64_t> all;
    for (const double value : values) all.push_back(std::bit_cast<std::uint64_t>(value));
    return all;
}

void expect_same(const std::vector<SnapshotField>& one, const std::vector<SnapshotField>& other) {
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t i = 0; i < one.size(); ++i)
        EXPECT_EQ(bits(one[i].values.values()), bits(other[i].values.values())) << one[i].name;
}

/// All that a picture, a table or a field file can show.
void expect_same(const Model& one, const Model& other) {
    EXPECT_EQ(hex(state_hash(one)), hex(state_hash(other)));
    EXPECT_EQ(one.time(), other.time());
    const Snapshot a = one.snapshot();
    const Snapshot b = other.snapshot();
    EXPECT_EQ(a.step, b.step);
    EXPECT_EQ(a.highest_expected, b.highest_expected);
    EXPECT_EQ(bits(a.bed.values()), bits(b.bed.values()));
    expect_same(a.fields, b.fields);
    ASSERT_EQ(a.numbers.size(), b.numbers.size());
    for (std::size_t i = 0; i < a.numbers.size(); ++i) {
        EXPECT_EQ(std::bit_cast<std::uint64_t>(a.numbers[i].value),
                  std::bit_cast<std::uint64_t>(b.numbers[i].value))
            << a.numbers[i].name;
    }
    ASSERT_EQ(a.section == nullptr, b.section == nullptr);
    if (!a.section) return;
    expect_same(a.section->fields, b.section->fields);
    for (std::size_t i = 0; i < a.section->curves.size(); ++i)
        EXPECT_EQ(bits(a.section->curves[i].values), bits(b.section->curves[i].values));
    ASSERT_EQ(a.section->paths.size(), b.section->paths.size());
    for (std::size_t i = 0; i < a.section->paths.size(); ++i)
        EXPECT_EQ(bits(a.section->paths[i].z), bits(b.section->paths[i].z));
}

struct ArchivedRun {
    std::string name;
    std::string scene;
    std::int64_t steps = 12;
};

void PrintTo(const ArchivedRun& one, std::ostream* out) {
    *out << one.name;
}

ArchivedRun sand(const std::string& name, const std::string& keys, int nx = 40, int ny = 24) {
    return {name, "[grid]\nnx = " + std::to_string(nx) + "\nny = " + std::to_string(ny) +
                      "\n[model]\nname = \"sand\"\n" + keys};
}
ArchivedRun pile(const std::string& name, const std::string& keys) {
    return {name,
            "[grid]\nnx = 14\nny = 12\n[model]\nname = \"sandpile\"\ngrains_per_step = 90\n" + keys,
            20};
}
ArchivedRun gully(const std::string& name, const std::string& keys) {
    return {name, "[grid]\nnx = 20\nny = 26\n[model]\nname = \"gully\"\n" + keys};
}
ArchivedRun dunes(const std::string& name, const std::string& keys) {
    return {name, "[grid]\nnx = 36\nny = 30\n[model]\nname = \"dunes\"\n" + keys +
                      "[[wind]]\nduration = 0.003\n[[wind]]\nfrom = 200\nduration = 0.002\n"};
}
ArchivedRun air(const std::string& name, const std::string& keys) {
    return {name,
            "[grid]\nnx = 32\n[model]\nname = \"airflow\"\nnz = 12\nbed_amplitude = 0.1\n" + keys,
            90};
}

class StateArchives : public ::testing::TestWithParam<ArchivedRun> {};

/// As a signal does it, so many seconds ago.
struct StopRequested {
    explicit StopRequested(double seconds_ago) {
        stop_requested_at_ns =
            monotonic_nanoseconds() - static_cast<std::int64_t>(1e9 * seconds_ago);
    }
    ~StopRequested() { stop_requested_at_ns = 0; }
    StopRequested(const StopRequested&) = delete;
    StopRequested& operator=(const StopRequested&) = delete;
};

TEST_P(StateArchives, AStepIsGivenUpOnlyWhenPatienceIsAtItsEnd) {
    const ArchivedRun& one = GetParam();
    if (one.name == "Static") return;  // its step does nothing
    const Built built(one.scene, 2);
    built.to(2);
    {
        const StopRequested just_now(0.0);
        EXPECT_NO_THROW(built.model->step());
    }
    const double time = built.model->time();
    const StopRequested before(1.01 * cancellation_grace_s);
    if (one.name == "HeldSteady") return;  // has come to rest
    EXPECT_THROW(built.model->step(), Cancelled);
    EXPECT_EQ(built.model->steps_done(), 3) << "the step is not done";
    EXPECT_EQ(built.model->time(), time);
}

/// Whether a long first step is given up soon after patience has ended within it.
void expect_given_up_midway(const std::string& scene) {
    SCOPED_TRACE(scene);
    constexpr double left = 0.02;  // seconds
    const Built built(scene, 2);
    const StopRequested before(cancellation_grace_s - left);
    const Stopwatch watch;
    EXPECT_THROW(built.model->step(), Cancelled);
    EXPECT_GE(watch.seconds(), left);
    EXPECT_LT(watch.seconds(), 10.0) << "of a step that takes longer";
}

TEST(LongStep, IsGivenUpMidway) {
    expect_given_up_midway(
        "[grid]\nnx = 150\nny = 150\n[bed]\nkind = \"flat\"\nheight = 40000\n"
        "[model]\nname = \"sandpile\"\n");  // one avalanche
    expect_given_up_midway(
        "[grid]\nnx = 150\nny = 150\n[bed]\nkind = \"flat\"\nheight = 40000\n"
        "[model]\nname = \"sandpile\"\norder = \"first-in-first-out\"\n");
    expect_given_up_midway(
        "[grid]\nnx = 4\nny = 4\n[model]\nname = \"sandpile\"\ngrains_per_step = 1000000000\n");
    expect_given_up_midway(
        "[grid]\nnx = 64\nny = 64\n[model]\nname = \"gully\"\ntime_step = 300\n");
    expect_given_up_midway(
        "[grid]\nnx = 4000000\nny = 1\n[model]\nname = \"sand\"\norder = "
        "\"random-sequential\"\n");
}

TEST_P(StateArchives, AModelBroughtBackAtAnyStepGoesOnWithTheSameBytes) {
    const TemporaryFolder folder;
    const ArchivedRun& one = GetParam();
    const Built straight(one.scene, 2);
    straight.to(one.steps);
    for (const std::int64_t stop :
         {std::int64_t{0}, std::int64_t{1}, one.steps / 3, one.steps / 2 + 1, one.steps}) {
        SCOPED_TRACE(stop);
        const Built before(one.scene, 1);
        before.to(stop);
        const Sha256 hash = state_hash(*before.model);
        CheckpointWriter writer(folder / "state");
        before.model->serialise(writer);
        writer.commit();
        EXPECT_EQ(state_hash(*before.model), hash) << "taking away leaves all as it was";

        const Built after(one.scene, 3);
        const auto reader = open_checkpoint(folder / "state");
        after.model->serialise(*reader);
        reader->finish();
        expect_same(*before.model, *after.model);
        after.to(one.steps);
        expect_same(*straight.model, *after.model);
    }
}

INSTANTIATE_TEST_SUITE_P(
    EveryModel, StateArchives,
    ::testing::Values(
        ArchivedRun{"Static", "[grid]\nnx = 9\nny = 8\n[model]\nname = \"static\"\n", 4},
        sand("Synchronous", ""), sand("RandomSequential", "order = \"random-sequential\"\n"),
        sand("Maxima", "order = \"random-sequential\"\ncreep = \"maxima-only\"\n"),
        sand("Dunes", "hop_length = \"slope\"\nhop_amount = \"slope\"\nlanding = \"split\"\n"),
        sand("HopsAlone", "creep = \"none\"\nlimit_amount = false\n"),
        sand("ProfileRows", "creep = \"profile\"\n"),
        sand("Profile", "order = \"random-sequential\"\ncreep = \"profile\"\n", 300, 1),
        sand("LongProfile", "order = \"random-sequential\"\ncreep = \"profile\"\n", 40000, 1),
        pile("Sweep", ""), pile("Queue", "order = \"first-in-first-out\"\n"),
        pile("Cycling", "drop_direction = \"cycling\"\norder = \"first-in-first-out\"\n"),
        pile("CircularMean",
             "direction = \"circular-mean\"\ntopple_toward = "
             "\"toward-direction\"\ndrop_direction = \"cycling\"\n"),
        pile("Sites", "drop_x = [3, 9, 6]\ndrop_y = [4, 2, 9]\ndrop_choice = \"random\"\n"),
        pile("SitesInTurn", "drop_x = [3, 9, 6]\ndrop_y = [4, 2, 9]\n"),
        gully("WaterThatComesIn",
              "friction = \"manning\"\ninfiltration = \"green-ampt\"\nrain_times = [0, "
              "0.5]\nrain_rates = [50, 90]\ntransport = \"none\"\nslope_x = 0.01\n[[water]]\n"
              "window = [3, 3, 9, 9]\ndepth = 0.4\n[[edge]]\nside = \"west\"\nkind = "
              "\"discharge\"\ntimes = [0, 1]\nvalues = [2, 6]\n[[edge]]\nside = \"north\"\n"
              "kind = \"level\"\nvalue = 0.2\n"),
        gully("Loads",
              "transport = \"loads\"\nentrainment = \"excess-shear\"\nentrainment_stress = 0.1\n"
              "depth = 0.05\nrain = 900\nedges_y = \"open\"\nbed_diffusion = 0.01\n"
              "morphological_factor = 50\nbase_level = 0.1\ntime_step = 0.4\n"),
        gully("Cip", "transport = \"as-printed\"\n"),
        gully("CipAsPublished", "scheme = \"cip-as-published\"\ndepth = 0.05\n"),
        gully("Sheet", "scheme = \"finite-volume\"\ntransport = \"conservative\"\n"),
        gully("Rain",
              "scheme = \"finite-volume\"\nedges_x = \"open\"\nedges_y = \"wall\"\nrain = "
              "500\nrain_until = 0.65\ninitial_water = \"dry\"\ntime_step = 0.15\n"),
        gully("SteepCip", "scheme = \"cip\"\nrelief = \"steep\"\nrain = 100\n"),
        gully("SteepSheet",
              "scheme = \"finite-volume\"\nrelief = \"steep\"\ntransport = \"conservative\"\n"),
        gully("SubSteps", "time_step = 0.9\ndepth = 0.05\n"), dunes("Barchans", ""),
        dunes("Ridges", "speed_up = \"height\"\n"),
        dunes("OpenEdges", "edges_x = \"open\"\ninflux = 0.5\nrock_level = -1\n"),
        dunes("CoveredRock", "rock = \"bed\"\nshadow = \"hard\"\n"),
        dunes("PlantsAndWornRock",
              "plants = \"grow\"\ngrass_cover = 0.4\nshrub_cover = 0.3\nshrub_share = "
              "0.5\ngrowth_period = 0.002\navalanche_age = true\nplant_pioneers = 9\nrock_wear = "
              "0.05\nwall_angle = 55\n"
              "[[feature]]\nshape = \"block\"\nx = 18\ny = 15\nlength = 8\nheight = 5\n"),
        dunes("SlabsAmongPlants",
              "transport = \"slabs\"\nspeed_up = \"none\"\nplants = \"grow\"\nshrub_cover = "
              "0.4\nshrub_share = 0.3\navalanche_age = true\ngrowth_period = 0.01\n"),
        dunes("Slabs", "transport = \"slabs\"\nspeed_up = \"none\"\n"),
        dunes("SlabsOneByOne",
              "transport = \"slabs\"\nspeed_up = \"height\"\norder = \"sequential\"\n"),
        air("Staircase", "flights = true\nshown_paths = 2\nlid_speed = 0.2\n"),
        air("SecondOrder", "advection = \"second-order\"\n"),
        air("Fitted", "scheme = \"boundary-fitted\"\ntime_step = 1e-6\n"),
        air("HeldSteady", "until_steady = true\nsteady_tolerance = 0.5\nviscosity = 1e-4\n")),
    [](const auto& one) { return one.param.name; });

TEST(CarryOfAModel, AnotherModelsOrSizesStateIsRefused) {
    const TemporaryFolder folder;
    const Built small(sand("", "").scene, 1);
    CheckpointWriter writer(folder / "state");
    small.model->serialise(writer);
    writer.commit();
    const auto refusal = [&](const std::string& scene) {
        return message_of<InputError>(
            [&] { Built(scene, 1).model->serialise(*open_checkpoint(folder / "state")); });
    };
    EXPECT_NE(refusal(sand("", "", 41).scene).find("its bed has a different size"),
              std::string::npos);
    EXPECT_NE(refusal(pile("", "").scene).find("holds \"bed\" where \"dropped_grains\""),
              std::string::npos);
}

TEST(CarryOfAModel, APileWithImpossibleCellsIsRefused) {
    const TemporaryFolder folder;
    const std::string scene = pile("", "").scene;
    const Built built(scene, 1);
    built.to(3);
    for (const std::int64_t wrong : {std::int64_t{-16}, std::int64_t{11}, std::int64_t{1} << 40}) {
        CheckpointWriter writer(folder / "state");
        for (const char* count : {"steps", "dropped_grains", "avalanches", "drawn_directions"}) {
            std::int64_t three = 3;
            writer.value(count, three);
        }
        std::vector<std::int64_t> cells(std::size_t{16} * 14, 10);
        std::vector<std::int64_t> changes(cells.size(), 0);
        for (std::size_t y = 1; y < 13; ++y) {
            for (std::size_t x = 1; x < 15; ++x) cells[16 * y + x] = 16;
        }
        cells[16 * 5 + 5] = wrong;
        std::int64_t lost = 0;
        writer.list("pile_cells", cells);
        writer.list("pile_changes", changes);
        writer.value("lost_grains", lost);
        writer.commit();
        EXPECT_THROW(Built(scene, 1).model->serialise(*open_checkpoint(folder / "state")),
                     InputError);
        EXPECT_NO_THROW(open_checkpoint(folder / "state"));
    }
}

}  // namespace
}  // namespace fumon::test
