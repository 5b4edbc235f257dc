// The network of gullies that ships, on a corner of its ground.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "base/snapshot_lookup.h"
#include "base/worker_pool.h"
#include "models/registry.h"
#include "scene/initial_bed.h"
#include "scene/read.h"

namespace fumon::test {
namespace {

constexpr int width = 64;
constexpr int length = 128;

/// scenes/gully-network.toml on 64 x 128 cells, in rain that makes as much water at its foot.
Snapshot network(const std::string& morphological_factor, int steps) {
    const Scene scene = read_scene(FUMON_SCENES_FOLDER "/gully-network.toml",
                                   {"grid.nx=64", "grid.ny=128", "model.rain=160",
                                    "model.morphological_factor=" + morphological_factor});
    InitialBed initial = make_initial_bed(scene);
    WorkerPool pool(1);
    const auto model = find_model(scene.model.name)
                           ->make(scene.model.parameters,
                                  {std::move(initial.bed), std::move(initial.nodata), initial.scale,
                                   static_cast<std::uint64_t>(scene.seed), pool, false});
    while (model->steps_done() < steps) model->step();
    return model->snapshot();
}

/// m²/s toward the south, of a row.
std::vector<double> discharges(const Snapshot& snapshot, int y) {
    const Grid& depth = *field_of(snapshot.fields, "water_depth");
    const Grid& v = *field_of(snapshot.fields, "velocity_y");
    std::vector<double> found;
    for (int x = 0; x < width; ++x) found.push_back(std::max(-depth(x, y) * v(x, y), 0.0));
    return found;
}

/// The share of a row's water that runs through a tenth of its cells, mean over the rows.
double gathered(const Snapshot& snapshot) {
    double sum = 0.0;
    for (int y = 0; y < length; ++y) {
        std::vector<double> row = discharges(snapshot, y);
        std::ranges::sort(row, std::greater<>());
        double all = 0.0;
        for (const double q : row) all += q;
        double most = 0.0;
        for (int x = 0; x < width / 10; ++x) most += row[static_cast<std::size_t>(x)];
        sum += most / all;
    }
    return sum / length;
}

/// Streams in a row: stretches of cells with over twice its mean discharge.
double streams(const Snapshot& snapshot, int first, int last) {
    double count = 0.0;
    for (int y = first; y < last; ++y) {
        const std::vector<double> row = discharges(snapshot, y);
        double mean = 0.0;
        for (const double q : row) mean += q / width;
        bool in_stream = false;
        for (const double q : row) {
            if (q > 2.0 * mean && !in_stream) count += 1.0;
            in_stream = q > 2.0 * mean;
        }
    }
    return count / (last - first);
}

TEST(GullyNetwork, GathersWaterInStreamsThatMeet) {
    const Snapshot uncut = network("0", 60);
    const Snapshot cut = network("4000", 110);
    EXPECT_LT(std::fabs(*number_of(cut, "sediment_budget_error")), 1e-12);
    EXPECT_GT(*number_of(cut, "eroded_volume"), 50.0);
    EXPECT_LT(gathered(uncut), 0.7);
    EXPECT_GT(gathered(cut), 0.75);
    for (const int row : {4, 90}) {
        EXPECT_GT(streams(uncut, row, row + 26), 8.0) << "threads between the bumps";
        EXPECT_LT(streams(cut, row, row + 26), 6.0) << "channels that others have joined";
        EXPECT_GT(streams(cut, row, row + 26), 2.0);
    }
    const Snapshot slower = network("2000", 220);  // the same time of the bed
    EXPECT_NEAR(gathered(slower), gathered(cut), 0.1 * gathered(cut));
    EXPECT_NEAR(streams(slower, 4, 116), streams(cut, 4, 116), 0.1 * streams(cut, 4, 116));
}

}  // namespace
}  // namespace fumon::test
