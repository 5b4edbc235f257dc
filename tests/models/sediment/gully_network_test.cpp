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

constexpr int width = 128;
constexpr int length = 64;

/// scenes/gully-network.toml on 128 x 64 cells, in rain that makes as much water at its foot.
Snapshot network(const std::string& morphological_factor, int steps) {
    const Scene scene =
        read_scene(FUMON_SCENES_FOLDER "/gully-network.toml",
                   {"grid.nx=128", "grid.ny=64", "model.rain=800", "model.bed_start=150",
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
    const Snapshot uncut = network("0", 10);
    const Snapshot cut = network("3000", 30);
    EXPECT_LT(std::fabs(*number_of(cut, "sediment_budget_error")), 1e-12);
    EXPECT_GT(*number_of(cut, "eroded_volume"), 5000.0);
    EXPECT_LT(gathered(uncut), 0.4);
    EXPECT_GT(gathered(cut), 0.65);
    EXPECT_LT(streams(cut, 4, 20), 0.85 * streams(cut, 44, 60)) << "streams have met downslope";
    EXPECT_GT(streams(cut, 4, 20), 8.0);
    const Snapshot slower = network("1500", 50);  // the same time of the bed
    EXPECT_NEAR(gathered(slower), gathered(cut), 0.1 * gathered(cut));
    EXPECT_NEAR(streams(slower, 4, 60), streams(cut, 4, 60), 0.1 * streams(cut, 4, 60));
    EXPECT_NEAR(*number_of(slower, "eroded_volume"), *number_of(cut, "eroded_volume"),
                0.2 * *number_of(cut, "eroded_volume"));
}

}  // namespace
}  // namespace fumon::test
