#include <gtest/gtest.h>

#include <cmath>

#include "files/hash.h"
#include "run/forecast/run_forecast.h"
#include "support/program.h"

namespace fumon::test {
namespace {

/// Seconds to the end of each of `steps` steps, which grow with a power of their number.
std::vector<double> seconds_of(int steps, double of_first, double power) {
    std::vector<double> after;
    for (int step = 1; step <= steps; ++step)
        after.push_back(of_first * std::pow(static_cast<double>(step), power));
    return after;
}

TEST(RunForecast, StepsThatStayAsLongAreCounted) {
    EXPECT_NEAR(forecast_seconds(seconds_of(10, 0.02, 1.0), 500), 10.0, 1e-9);
    EXPECT_NEAR(forecast_seconds({0.3}, 5), 1.5, 1e-12);
    std::vector<double> slow_start = seconds_of(20, 0.01, 1.0);
    for (double& seconds : slow_start) seconds += 0.5;  // that the first step took
    EXPECT_NEAR(forecast_seconds(slow_start, 1000), 10.5, 1e-9);
}

// Rain on a gully of 129 x 267 cells with loads: the seconds after so many steps, read on one
// thread. What 50 to 200 of them tell of 900 is within a factor of two.
TEST(RunForecast, OfAGullyIsWithinAFactorOfTwo) {
    constexpr double all = 39.9;
    struct Read {
        int steps;
        double seconds;
        double power;  // from there back to a quarter of it
    };
    for (const Read& read : {Read{50, 0.85, 1.23}, Read{200, 6.0, 1.41}, Read{450, 17.1, 1.29}}) {
        const double of_first = read.seconds / std::pow(read.steps, read.power);
        const double told = forecast_seconds(seconds_of(read.steps, of_first, read.power), 900);
        EXPECT_GT(told, all / 2.0) << read.steps;
        EXPECT_LT(told, all * 2.0) << read.steps;
    }
}

TEST(RunForecast, SaysNothingOfWhatIsSoonDone) {
    RunForecast small{0.4, 2, 1000, 1000, 8};
    EXPECT_EQ(forecast_text(small), "");
    small.frames_bytes = 700'000'000;
    EXPECT_EQ(forecast_text(small), "");
    EXPECT_EQ(forecast_text({226.0, 2, 0, 566'600'000, 50}),
              "about 3:46 in steps on 2 threads, at most 567 MB of frames");
    EXPECT_EQ(forecast_text({1.0, 1, 824'000'000, 0, 50}), "at most 824 MB of fields");
}

TEST(RunForecast, FieldsAreAtMostAsLargeAsCheckSays) {
    const ScratchFolder folder;
    write_text(folder / "scene.toml",
               "[model]\nname = \"sand\"\n[grid]\nnx = 64\nny = 48\n[run]\nsteps = 20\n"
               "[bed]\nkind = \"noise\"\n[output]\nfields_every = 1\nframes = false\n"
               "movie = false\n");
    const Ended checked = fumon({"check", "scene.toml", "--json"}, folder.path());
    ASSERT_EQ(checked.status, 0) << checked.errors;
    const auto forecast = nlohmann::json::parse(checked.output).at(0).at("forecast");
    EXPECT_GT(forecast.at("seconds_of_steps"), 0.0);
    EXPECT_EQ(forecast.at("most_bytes_of_frames"), 0);
    ASSERT_EQ(fumon({"run", "scene.toml", "-o", "out", "-q"}, folder.path()).status, 0);
    const auto most = forecast.at("most_bytes_of_fields").get<std::uintmax_t>();
    const std::uintmax_t made = std::filesystem::file_size(folder / "out/fields.nc");
    EXPECT_GE(most, made);
    EXPECT_LE(most, 21U * (64U * 48U * 8U * 4U + 100'000U)) << "three fields and the bed";
}

TEST(UnstableRun, NamesFirstWhatSetChanged) {
    const ScratchFolder folder;
    write_text(folder / "scene.toml", small_scene());
    std::vector<std::string> arguments{"run", "scene.toml", "-o", "out", "-q"};
    for (const std::string& word : settings_that_leave_the_range()) arguments.push_back(word);
    arguments.insert(arguments.end(), {"--set", "bed.high=999999"});
    const Ended failed = fumon(arguments, folder.path());
    EXPECT_EQ(failed.status, 3);
    EXPECT_NE(failed.errors.find("; try model.hop_amount nearer to"), std::string::npos)
        << failed.errors;
    EXPECT_NE(failed.errors.find("model.creep_rate nearer to the scene's own "), std::string::npos)
        << failed.errors;
    EXPECT_NE(failed.errors.find("; or smaller rates"), std::string::npos) << failed.errors;
}

}  // namespace
}  // namespace fumon::test
