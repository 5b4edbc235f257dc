#include "view/sweep/sweep_pages.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "base/error.h"
#include "support/program.h"
#include "support/viewed_run.h"

namespace fumon {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::contains;
using test::read_text;
using test::ScratchFolder;
using test::write_text;

/// Of two creep rates, two amounts and two seeds.
fs::path small_sweep(const fs::path& folder) {
    write_text(folder / "viewed.toml", viewed_scene);
    const test::Ended ended =
        test::fumon({"sweep", "viewed.toml", "--over", "model.creep_rate=0.1,0.2", "--over",
                     "model.amount=0.1,0.3", "--seeds", "2", "-o", "sweep", "-q"},
                    folder);
    EXPECT_EQ(ended.status, 0) << ended.errors;
    return folder / "sweep";
}

HttpAnswer get_of(Pages& pages, const std::string& path, const std::string& run = {}) {
    HttpRequest request{"GET", path, {}, {}};
    if (!run.empty()) request.query["run"] = run;
    return pages.answer(request);
}

TEST(SweepPages, PlacesTheRunsOnTheirAxes) {
    const ScratchFolder folder;
    SweepPages pages(small_sweep(folder.path()), {});
    const json sweep = json::parse(get_of(pages, "sweep").body);
    ASSERT_EQ(sweep["axes"].size(), 3U);
    EXPECT_EQ(sweep["axes"][0]["label"], "model.creep_rate");
    EXPECT_EQ(sweep["axes"][0]["unit"], "share per step");
    EXPECT_EQ(sweep["axes"][1]["values"], (json{"0.1", "0.3"}));
    EXPECT_EQ(sweep["axes"][2]["label"], "seed");
    ASSERT_EQ(sweep["runs"].size(), 8U);
    EXPECT_EQ(sweep["runs"][6]["at"], (json{1, 1, 0}));
    for (const json& run : sweep["runs"]) {
        EXPECT_EQ(run["status"], "done");
        EXPECT_TRUE(run["stored"]);
    }
    EXPECT_FALSE(json::parse(get_of(pages, "about").body)["job"]);
    EXPECT_TRUE(contains(get_of(pages, "").body, "watch.js"));
}

TEST(SweepPages, ShowsRunsSmallAndInTheViewer) {
    const ScratchFolder folder;
    SweepPages pages(small_sweep(folder.path()), {});
    const HttpAnswer first = get_of(pages, "picture", "1");
    EXPECT_EQ(first.type, "image/jpeg");
    EXPECT_TRUE(first.body != get_of(pages, "picture", "3").body);
    EXPECT_TRUE(first.body == get_of(pages, "picture", "1").body);
    for (const char* run : {"1", "2", "3", "4", "5", "6"}) {  // more than are kept
        const json subject =
            json::parse(get_of(pages, std::string("run/") + run + "/subject").body);
        EXPECT_TRUE(contains(subject["name"], std::string("run ") + run));
        EXPECT_EQ(subject["moments"].back()["step"], 12);
    }
    EXPECT_TRUE(contains(get_of(pages, "run/1/").body, "view.js"));
    EXPECT_THROW(get_of(pages, "run/9/"), InputError);
    for (const char* path : {"run/0/", "run/-1/", "run/x/", "run/1", "run/", "run/../",
                             "run/1/../2/", "runs/0001.json", "run/99999999999999999999/"})
        EXPECT_EQ(get_of(pages, path).status, 404) << path;
    EXPECT_EQ(get_of(pages, "picture", "../1").status, 404);
}

TEST(SweepPages, MarksTheRunsThatFailedOrAreToCome) {
    const ScratchFolder folder;
    const fs::path sweep = small_sweep(folder.path());
    json record = json::parse(read_text(sweep / "runs" / "0003.json"));
    record["failed"] = true;
    record["message"] = "the bed is not finite";
    write_text(sweep / "runs" / "0003.json", record.dump());
    fs::rename(sweep / "runs" / "0008.json", folder / "later.json");
    fs::remove(sweep / "runs" / "0005-fields.nc");
    SweepPages pages(sweep, {});
    json runs = json::parse(get_of(pages, "sweep").body)["runs"];
    EXPECT_EQ(runs[2]["status"], "failed");
    EXPECT_EQ(runs[2]["message"], "the bed is not finite");
    EXPECT_FALSE(runs[4]["stored"]);
    EXPECT_EQ(runs[7]["status"], "pending");
    for (const char* run : {"3", "5", "8"}) EXPECT_THROW(get_of(pages, "picture", run), InputError);
    fs::rename(folder / "later.json", sweep / "runs" / "0008.json");
    std::this_thread::sleep_for(std::chrono::milliseconds(1600));
    runs = json::parse(get_of(pages, "sweep").body)["runs"];
    EXPECT_EQ(runs[7]["status"], "done");
}

TEST(SweepPages, PlacesTheRunsOfASweepThatGrows) {
    const ScratchFolder folder;
    const fs::path sweep = small_sweep(folder.path());
    fs::remove(sweep / "runs.csv");
    std::string manifest = read_text(sweep / "sweep.json");
    manifest.replace(manifest.find("\"0.2\""), 5, "\"0.20\"");  // as it may be written
    write_text(sweep / "sweep.json", manifest);
    SweepPages pages(sweep, {});
    write_text(sweep / "runs.csv", "run,model.creep_rate,model.amount,seed\n1,0.2,0.3,1\n");
    const json runs = json::parse(get_of(pages, "sweep").body)["runs"];
    EXPECT_EQ(runs[0]["at"], (json{1, 1, 0}));
}

TEST(SweepPages, RefusesAManifestThatIsDamaged) {
    const ScratchFolder folder;
    for (const char* text :
         {"", "{}", "[]", "{\"scene\":{\"model\":{\"name\":\"sand\"}},\"over\":1}",
          "{\"scene\":{\"model\":{\"name\":\"sand\"}},\"over\":[],\"seeds\":"
          "{\"first\":1,\"last\":900000000000},\"runs\":[]}"}) {
        write_text(folder / "sweep.json", text);
        EXPECT_TRUE(is_sweep_folder(folder.path()));
        EXPECT_THROW(SweepPages(folder.path(), {}), InputError) << text;
    }
}

}  // namespace
}  // namespace fumon
