#include "view/scene/scene_pages.h"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "base/error.h"
#include "scene/read.h"
#include "support/program.h"
#include "support/raw_http.h"
#include "support/viewed_run.h"
#include "view/scene/dropped_terrain.h"
#include "view/subject/stored_subject.h"

namespace fumon {
namespace {

using nlohmann::json;
using test::contains;
using test::read_text;
using test::ScratchFolder;
using test::write_text;

std::unique_ptr<ScenePages> viewed_pages(const ViewOptions& options = {}) {
    const auto read = [](const std::vector<std::string>& settings) {
        return parse_scene(viewed_scene, "viewed.toml", ".", settings);
    };
    return std::make_unique<ScenePages>("viewed.toml", prepare_run(read({}), 1),
                                        std::vector<std::filesystem::path>{}, read, options);
}

HttpAnswer post_to(Pages& pages, const std::string& path, const json& body) {
    return pages.answer({"POST", path, {}, body.dump()});
}

HttpAnswer drawn_by(Pages& pages, const json& request) {
    for (;;) {
        HttpAnswer answer = post_to(pages, "picture", request);
        if (answer.status != 202) return answer;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
}

TEST(ScenePages, OtherValuesOfTheModelAreComputedAnew) {
    const ScratchFolder folder;
    const auto pages = viewed_pages();
    const json settings = {"model.creep_rate=0.3", "sun.elevation=40"};
    const HttpAnswer other = drawn_by(*pages, {{"moment", 6}, {"settings", settings}});
    ASSERT_EQ(other.status, 200);
    json progress = json::parse(post_to(*pages, "progress", {{"settings", settings}}).body);
    EXPECT_TRUE(progress["moments"][6]["ready"]);
    progress = json::parse(post_to(*pages, "progress", {{"settings", {"sun.elevation=40"}}}).body);
    EXPECT_FALSE(progress["moments"][6]["ready"]);
    write_text(folder / "viewed.toml", viewed_scene);
    ASSERT_EQ(test::fumon({"still", "viewed.toml", "--step", "6", "-o", "still.png", "-q", "--set",
                           "model.creep_rate=0.3", "--set", "sun.elevation=40"},
                          folder.path())
                  .status,
              0);
    EXPECT_TRUE(other.body == read_text(folder / "still.png"));
    const HttpAnswer scene = post_to(*pages, "scene", {{"settings", settings}});
    EXPECT_TRUE(contains(scene.body, "creep_rate = 0.3"));
}

TEST(ScenePages, SaysWhatCheckSaysOfTheModelsKeys) {
    const ScratchFolder folder;
    write_text(folder / "viewed.toml", viewed_scene);
    const auto pages = viewed_pages();
    for (const char* setting :
         {"model.creep_rate=-1", "model.creep_rate=0.9", "model.order=round", "model.colour=1"}) {
        const json fault = json::parse(post_to(*pages, "check", {{"settings", {setting}}}).body);
        const auto checked =
            test::fumon({"check", "viewed.toml", "--set", setting}, folder.path()).errors;
        EXPECT_TRUE(contains(checked, fault.value("fault", "no fault"))) << fault << checked;
        EXPECT_THROW(post_to(*pages, "picture", {{"settings", {setting}}}), InputError);
    }
    const json good = {{"settings", {"model.creep_rate=0.3"}}};
    EXPECT_TRUE(json::parse(post_to(*pages, "check", good).body).empty());
    for (const char* setting : {"model.name=water", "run.steps=9", "bed.file=/etc/passwd"})
        EXPECT_THROW(post_to(*pages, "picture", {{"settings", {setting}}}), InputError) << setting;
}

TEST(ScenePages, KeepsModelsWithinTheLimitsOfUnknownOrigin) {
    const auto read = [](const std::vector<std::string>& settings) {
        return parse_scene(
            "[model]\nname = \"sandpile\"\n[grid]\nnx = 16\nny = 16\n[run]\nsteps = 10000\n",
            "pile.toml", ".", settings);
    };
    const auto pages_with = [&](bool trust) {
        ViewOptions options;
        options.trust = trust;
        return std::make_unique<ScenePages>("pile.toml", prepare_run(read({}), 1),
                                            std::vector<std::filesystem::path>{}, read, options);
    };
    const json many = {{"settings", {"model.grains_per_step=1000000"}}};
    EXPECT_TRUE(contains(post_to(*pages_with(false), "check", many).body, "--trust"));
    EXPECT_THROW(post_to(*pages_with(false), "progress", many), InputError);
    EXPECT_TRUE(json::parse(post_to(*pages_with(true), "check", many).body).empty());
}

TEST(ScenePages, OfAStoredRunTheModelsKeysAreFixed) {
    const ScratchFolder folder;
    SubjectPages stored(stored_subject(viewed_run(folder.path()), 1, {}), {});
    const auto fixed = [](Pages& pages) {
        const json subject = json::parse(pages.answer({"GET", "subject", {}, {}}).body);
        for (const json& key : subject["keys"])
            if (key["key"] == "model.creep_rate") return key.contains("fixed") ? 1 : 0;
        return -1;
    };
    EXPECT_EQ(fixed(stored), 1);
    EXPECT_EQ(fixed(*viewed_pages()), 0);
    EXPECT_THROW(post_to(stored, "picture", {{"settings", {"model.creep_rate=0.3"}}}), InputError);
}

TEST(ScenePages, OverlaysAreAddedAndLooksTaken) {
    const auto pages = viewed_pages();
    const json subject = json::parse(pages->answer({"GET", "subject", {}, {}}).body);
    EXPECT_EQ(subject["further_overlay"][0]["key"], "overlay.0.kind");
    const HttpAnswer plain = drawn_by(*pages, {{"moment", 0}});
    const HttpAnswer titled =
        drawn_by(*pages, {{"moment", 0}, {"settings", {"overlay.0.kind=\"title\""}}});
    EXPECT_TRUE(plain.body != titled.body);
    const json looks = json::parse(pages->answer({"GET", "presets", {}, {}}).body);
    ASSERT_GT(looks.size(), 5U);
    for (const json& look : looks) {
        EXPECT_EQ(look["settings"].size(), looks[0]["settings"].size());
        json settings = json::array();
        for (const auto& [path, value] : look["settings"].items())
            settings.push_back(path + "=" + value.get<std::string>());
        EXPECT_TRUE(json::parse(post_to(*pages, "check", {{"settings", settings}}).body).empty())
            << look["name"];
    }
}

constexpr const char* small_terrain =
    "ncols 4\nnrows 3\nxllcorner 0\nyllcorner 0\ncellsize 10\n1 2 3 4\n2 3 4 5\n3 4 5 6\n";

HttpAnswer drop(Pages& pages, const std::string& name, const std::string& bytes) {
    return pages.answer({"POST", "terrain", {{"name", name}}, bytes});
}

TEST(DroppedTerrain, IsOpenedBesideWhatIsShown) {
    DroppedTerrain pages(viewed_pages(), {});
    EXPECT_TRUE(json::parse(pages.answer({"GET", "subject", {}, {}}).body)["name"] ==
                "viewed.toml");
    const HttpAnswer opened = drop(pages, "../../my dem.asc", small_terrain);
    EXPECT_EQ(json::parse(opened.body)["open"], "terrain/1/");
    const json subject = json::parse(pages.answer({"GET", "terrain/1/subject", {}, {}}).body);
    EXPECT_EQ(subject["name"], "my dem.asc");
    EXPECT_EQ(subject["grid"]["nx"], 4);
    EXPECT_TRUE(subject["drops"]);
    EXPECT_EQ(pages.answer({"POST", "terrain/1/picture", {}, R"({"width":64,"height":36})"}).type,
              "image/png");
    for (int i = 0; i < 4; ++i) drop(pages, "next.asc", small_terrain);
    EXPECT_EQ(pages.answer({"GET", "terrain/1/subject", {}, {}}).status, 404);
    EXPECT_EQ(pages.answer({"GET", "terrain/5/subject", {}, {}}).status, 200);
    for (const char* path : {"terrain/", "terrain/5", "terrain/x/", "terrain/../", "terrain/9/"})
        EXPECT_EQ(pages.answer({"GET", path, {}, {}}).status, 404) << path;
}

TEST(DroppedTerrain, ItsFilesAreDeletedWithIt) {
    const ScratchFolder folder;
    std::filesystem::create_directories(folder / "temporary");
    write_text(folder / "viewed.toml", viewed_scene);
    test::Program program({"view", "viewed.toml"}, folder.path(),
                          {"TMPDIR=" + (folder / "temporary").string()});
    for (int i = 0; i < 600 && !contains(program.output(), "ssh -L"); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    const std::string said = program.output();
    const std::string begin = "http://127.0.0.1:";
    ASSERT_TRUE(said.starts_with(begin)) << said;
    const int port = std::stoi(said.substr(begin.size()));
    std::string base = said.substr(said.find('/', begin.size()));
    base.erase(base.find('\n'));
    const auto files = [&] {
        int count = 0;
        for (const auto& entry :
             std::filesystem::recursive_directory_iterator(folder / "temporary"))
            count += entry.is_regular_file() ? 1 : 0;
        return count;
    };
    EXPECT_TRUE(std::filesystem::is_empty(folder / "temporary"));
    for (int i = 0; i < 6; ++i)
        ask(port, "POST", base + "terrain?name=a.asc", "127.0.0.1", "", small_terrain);
    EXPECT_EQ(files(), 4);
    program.send(SIGTERM);
    EXPECT_EQ(program.wait().status, 0);
    EXPECT_TRUE(std::filesystem::is_empty(folder / "temporary"));
}

TEST(DroppedTerrain, RefusesWhatIsNoTerrainOrNamesOtherFiles) {
    DroppedTerrain pages(viewed_pages(), {});
    const std::string vrt =
        "<VRTDataset rasterXSize=\"2\" rasterYSize=\"2\"><VRTRasterBand dataType=\"Float32\" "
        "band=\"1\"><SimpleSource><SourceFilename>/etc/passwd</SourceFilename></SimpleSource>"
        "</VRTRasterBand></VRTDataset>";
    for (const std::string& bytes : {std::string(), std::string("a letter"), vrt,
                                     std::string("ncols 999999\nnrows 999999\ncellsize 1\n1 2\n"),
                                     std::string("ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\n"
                                                 "cellsize 1\n1 2\n"),
                                     std::string("\x89PNG\r\n\x1a\n cut")}) {
        try {
            drop(pages, "dem.tif", bytes);
            ADD_FAILURE() << bytes;
        } catch (const InputError& refusal) {
            EXPECT_TRUE(contains(refusal.what(), "dem.tif")) << refusal.what();
            EXPECT_FALSE(contains(refusal.what(), "/tmp")) << refusal.what();
        }
    }
}

}  // namespace
}  // namespace fumon
