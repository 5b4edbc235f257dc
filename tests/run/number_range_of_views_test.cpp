// Every door through which heights come, with every ground and projection behind it: up to the ends
// of the range (base/limits.h) there is a picture, beyond them a refusal of one line. Python's
// doors are in tests/python/test_number_range.py, those of the renderer itself in
// tests/render/number_range_test.cpp.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <thread>
#include <vector>

#include "base/error.h"
#include "base/limits.h"
#include "bmi/coupled_model.h"
#include "run/prepared_run.h"
#include "run/still.h"
#include "scene/read.h"
#include "support/forged_checkpoint.h"
#include "support/program.h"

namespace fumon::test::number_range {
namespace {

namespace fs = std::filesystem;

/// A ground and how it is seen, as a scene's lines.
struct VisibleGround {
    const char* name;
    std::string lines;
};

std::vector<VisibleGround> seen_grounds() {
    std::vector<VisibleGround> all{{"endless", "look.ground = \"endless\"\n"}};
    for (const char* projection : {"perspective", "orthographic", "map"}) {
        for (const char* mode : {"scenic", "figure"}) {
            all.push_back({projection, fmt::format("look.ground = \"table\"\nlook.mode = \"{}\"\n"
                                                   "camera.projection = \"{}\"\n",
                                                   mode, projection)});
        }
    }
    return all;
}

/// Where a door's range ends, and whether it takes "nan" for a cell without data.
struct Ends {
    double low = -largest_height;
    double high = largest_height;
    bool nan_is_no_data = false;
};

std::vector<double> beyond(const Ends& ends) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    std::vector<double> all{std::nextafter(ends.high, infinite),
                            std::nextafter(ends.low, -infinite),
                            4e38,
                            1e300,
                            -1.797e308,
                            infinite};
    if (!ends.nan_is_no_data) all.push_back(std::nan(""));
    return all;
}

/// As TOML, ESRI's grids and tables have it.
std::string number(double height) {
    return fmt::format("{:.17g}", height);
}

class NumberRangeOfViews : public ::testing::Test {
  protected:
    /// Puts a height into the door of a scene, and gives the scene's text.
    using Door = std::function<std::string(double height)>;

    [[nodiscard]] std::string scene(const std::string& model, const std::string& more) const {
        return "model.name = \"" + model +
               "\"\nimage.width = 16\nimage.height = 16\nimage.supersampling = 1\nrun.steps = 2\n" +
               more;
    }

    [[nodiscard]] PreparedRun prepared(const std::string& text) const {
        return prepare_run(parse_scene(text, "scene.toml", folder_.path()), 1);
    }

    /// What drawing the scene's first picture comes to: "drawn", or what refuses it.
    [[nodiscard]] std::string outcome(const std::string& text) const {
        try {
            const PreparedRun run = prepared(text);
            const Snapshot first = run.model->snapshot();
            const Image image = draw_snapshot(still_subject(run), first, first, {}).image;
            return image.rgb.size() == 768 ? "drawn" : "a picture of another size";
        } catch (const InputError& refusal) {
            return refusal.what();
        }
    }

    void hold(const char* name, const Door& door, const Ends& ends = {}) const {
        for (const VisibleGround& seen : seen_grounds()) {
            for (const double height : {ends.low, ends.high}) {
                const std::string what = outcome(seen.lines + door(height));
                EXPECT_TRUE(what == "drawn" || what.find("beds without water") < what.size())
                    << name << " " << height << "\n"
                    << seen.lines << what;
            }
            for (const double height : beyond(ends)) {
                const std::string why = outcome(seen.lines + door(height));
                EXPECT_NE(why, "drawn") << name << " " << height << "\n" << seen.lines;
                EXPECT_EQ(why.find('\n'), std::string::npos) << why;
            }
        }
    }

    ScratchFolder folder_;
};

TEST_F(NumberRangeOfViews, OfKeys) {
    hold("bed.height", [&](double height) {
        return scene("static", "grid.nx = 8\ngrid.ny = 6\nbed.kind = \"flat\"\nbed.height = " +
                                   number(height) + "\n");
    });
    hold("bed.low or bed.high", [&](double height) {
        return scene("static", "grid.nx = 8\ngrid.ny = 6\nbed.kind = \"noise\"\nbed.low = " +
                                   number(height < 0.0 ? height : 0.0) +
                                   "\nbed.high = " + number(height < 0.0 ? 1.0 : height) + "\n");
    });
}

TEST_F(NumberRangeOfViews, OfFiles) {
    hold(
        "bed.file",
        [&](double height) {
            write_text(folder_ / "bed.asc",
                       "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 10\n0 1 0 0 2 " +
                           number(height) + "\n");
            return scene("static", "bed.kind = \"file\"\nbed.file = \"bed.asc\"\n");
        },
        Ends{.nan_is_no_data = true});
}

/// The water's level along a side, over time.
TEST_F(NumberRangeOfViews, OfTables) {
    hold(
        "edge.table",
        [&](double height) {
            write_text(folder_ / "level.csv", "seconds,value\n0,1\n10," + number(height) + "\n");
            return scene("water",
                         "grid.nx = 8\ngrid.ny = 6\n[[edge]]\nside = \"west\"\nkind = \"level\"\n"
                         "table = \"level.csv\"\n");
        },
        Ends{-1e5, 1e9});
}

TEST_F(NumberRangeOfViews, OfCouplings) {
    for (const VisibleGround& seen : seen_grounds()) {
        write_text(folder_ / "bed.toml",
                   seen.lines + scene("static", "grid.nx = 8\ngrid.ny = 6\n"));
        CoupledModel model((folder_ / "bed.toml").string());
        const Variable& bed = model.variables().front();
        std::vector<double> heights(48, largest_height);
        heights[9] = -largest_height;
        model.set(bed, heights);
        const PreparedRun look = prepared(read_text(folder_ / "bed.toml"));
        EXPECT_EQ(draw_snapshot(still_subject(look), model.now(), model.now(), {}).image.rgb.size(),
                  768U)
            << seen.lines;
        for (const double height : beyond(Ends{})) {
            heights[7] = height;
            EXPECT_THROW(model.set(bed, heights), InputError) << height << "\n" << seen.lines;
            EXPECT_EQ(model.values(bed)[7], largest_height) << "the model is as it was";
        }
    }
}

TEST_F(NumberRangeOfViews, OfCheckpoints) {
    const fs::path file = folder_ / "out" / "checkpoint.fumon";
    for (const VisibleGround& seen : seen_grounds()) {
        fs::remove_all(folder_ / "out");
        write_text(folder_ / "scene.toml",
                   seen.lines +
                       "model.name = \"sand\"\nrun.steps = 1000000\ngrid.nx = 12\ngrid.ny "
                       "= 8\ngrid.cell_size = 1\noutput.movie = false\n"
                       "image.width = 16\nimage.height = 16\nframes.every = 1000000\n");
        Program running({"run", "scene.toml", "-o", "out", "-q", "--checkpoint-every", "0.000001"},
                        folder_.path());
        for (int wait = 0; wait < 6000 && !fs::exists(file); ++wait)
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        running.send(SIGINT);
        ASSERT_EQ(running.wait().status, 130) << seen.lines;
        const std::string whole = read_text(file);
        const auto reals = reals_of(whole);
        const auto bed = std::find_if(reals.begin(), reals.end(),
                                      [](const auto& entry) { return entry.first == "bed"; });
        ASSERT_NE(bed, reals.end());
        for (const double height : beyond(Ends{})) {
            write_text(file, forged_checkpoint(whole, bed->second, height));
            const Ended ended = fumon({"run", "--resume", "out", "-q"}, folder_.path());
            EXPECT_EQ(ended.status, 2) << height << "\n" << seen.lines << ended.errors;
            EXPECT_NE(ended.errors.find("out/checkpoint.fumon: its "), std::string::npos)
                << ended.errors;
            EXPECT_EQ(std::count(ended.errors.begin(), ended.errors.end(), '\n'), 1);
        }
    }
}

}  // namespace
}  // namespace fumon::test::number_range
