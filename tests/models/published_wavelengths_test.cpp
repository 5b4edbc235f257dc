// Wavelengths of ripples against numbers from independent programs, means over five seeds.

#include <gtest/gtest.h>

#include "measure/wavelength.h"
#include "models/sand.h"
#include "scene/initial_bed.h"
#include "scene/read.h"
#include "support/worker_pool.h"

namespace fumon {
namespace {

struct Published {
    const char* name;
    const char* scene;
    const char* change;
    std::int64_t step;
    double wavelength;
    double tolerance;
};

void PrintTo(const Published& one, std::ostream* out) {
    *out << one.name;
}

class PublishedWavelength : public testing::TestWithParam<Published> {};

TEST_P(PublishedWavelength, IsFound) {
    const Published& expected = GetParam();
    double sum = 0.0;
    constexpr int seeds = 5;
    for (int seed = 1; seed <= seeds; ++seed) {
        const Scene scene =
            read_scene(std::string(FUMON_SCENES_FOLDER) + "/" + expected.scene,
                       {"seed=" + std::to_string(seed), expected.change, "run.steps=5000"});
        const InitialBed initial = make_initial_bed(scene);
        WorkerPool pool(2);
        Sand sand(std::any_cast<const SandParameters&>(scene.model.parameters),
                  {initial.bed, {}, {}, static_cast<std::uint64_t>(seed), pool});
        while (sand.steps_done() < expected.step) sand.step();
        sum += wavelength_spectrum(sand.snapshot().bed, true);
    }
    EXPECT_NEAR(sum / seeds, expected.wavelength, expected.tolerance);
}

// The tolerances are the published standard deviations between seeds, times three over the root of
// five, or 1 %.
INSTANTIATE_TEST_SUITE_P(
    All, PublishedWavelength,
    testing::Values(
        Published{"terada_rounded", "terada-ripples.toml", "model.landing=round", 300, 7.66, 0.08},
        Published{"terada_truncated", "terada-ripples.toml", "model.landing=truncate", 300, 7.18,
                  0.08},
        Published{"terada_exponential", "terada-exponential-ripples.toml", "model.landing=round",
                  300, 7.23, 0.13},
        Published{"sudo_program", "sudo-ripples.toml", "model.hop_base=3.0", 5000, 10.1, 0.22},
        Published{"sudo_program_weak_wind", "sudo-ripples.toml", "model.hop_base=1.0", 5000, 6.14,
                  0.07},
        Published{"sudo_text", "sudo-ripples.toml", "model.creep=every-cell", 5000, 8.37, 0.09}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace fumon
