// Separate dunes against numbers from independent programs, means over five seeds.

#include <gtest/gtest.h>

#include "measure/dunes.h"
#include "models/sand.h"
#include "scene/initial_bed.h"
#include "scene/read.h"
#include "support/worker_pool.h"

namespace fumon {
namespace {

struct DuneMeans {
    double number = 0.0;
    double share_horns_downwind = 0.0;
    double horn_lag = 0.0;
    double covered_share = 0.0;
};

DuneMeans means_of(const char* scene_file, std::int64_t step) {
    constexpr int seeds = 5;
    DuneMeans means;
    for (int seed = 1; seed <= seeds; ++seed) {
        const Scene scene = read_scene(std::string(FUMON_SCENES_FOLDER) + "/" + scene_file,
                                       {"seed=" + std::to_string(seed)});
        WorkerPool pool(2);
        Sand sand(std::any_cast<const SandParameters&>(scene.model.parameters),
                  {make_initial_bed(scene).bed, {}, {}, static_cast<std::uint64_t>(seed), pool});
        while (sand.steps_done() < step) sand.step();
        const DuneField found = separate_dunes(sand.snapshot().bed, true);
        means.number += static_cast<double>(found.dunes.size()) / seeds;
        means.share_horns_downwind += found.share_horns_downwind / seeds;
        means.horn_lag += found.mean_horn_lag / seeds;
        means.covered_share += found.covered_share / seeds;
    }
    return means;
}

// The number within a factor of 1.6, the share with horns downwind at least 0.75, the cover within
// 12 %.

TEST(PublishedDunes, OfSudoWithAShadowZone) {
    const DuneMeans found = means_of("sudo-barchans.toml", 3000);
    EXPECT_GT(found.number, 5.2 / 1.6);
    EXPECT_LT(found.number, 5.2 * 1.6);
    EXPECT_DOUBLE_EQ(found.share_horns_downwind, 1.0);
    EXPECT_GT(found.horn_lag, 0.0);
    EXPECT_NEAR(found.covered_share, 0.086, 0.12 * 0.086);
}

TEST(PublishedDunes, OfNishimorisModel) {
    const DuneMeans found = means_of("terada-barchans.toml", 1000);
    EXPECT_GT(found.number, 14.5 / 1.6);
    EXPECT_LT(found.number, 14.5 * 1.6);
    EXPECT_GT(found.share_horns_downwind, 0.75);
    EXPECT_GT(found.horn_lag, 0.0);
}

}  // namespace
}  // namespace fumon
