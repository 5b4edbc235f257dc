#include "view/view_page.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <functional>
#include <latch>
#include <memory>
#include <nlohmann/json.hpp>
#include <semaphore>
#include <string>
#include <thread>
#include <vector>

#include "base/error.h"
#include "film/film_read.h"
#include "support/program.h"
#include "support/viewed_run.h"
#include "view/subject/stored_subject.h"

namespace fumon {
namespace {

using nlohmann::json;
using test::contains;
using test::fumon;
using test::read_text;
using test::ScratchFolder;
using test::write_text;

json read(const HttpAnswer& answer) {
    return json::parse(answer.body);
}

/// A scene whose moment 1 is there once it is let in; asked for once.
class GatedSubject : public ViewSubject {
  public:
    [[nodiscard]] std::string name() const override { return inner_->name(); }
    [[nodiscard]] const Scene& scene() const override { return inner_->scene(); }
    [[nodiscard]] const std::vector<InputFile>& inputs() const override { return inner_->inputs(); }
    [[nodiscard]] const Snapshot& first() const override { return inner_->first(); }
    [[nodiscard]] std::vector<ShownMoment> moments() override { return inner_->moments(); }
    [[nodiscard]] std::shared_ptr<const Snapshot> snapshot(std::size_t number) override {
        if (number == 1) {
            asked.count_down();
            open.wait();
        }
        return inner_->snapshot(0);
    }
    [[nodiscard]] MeasuredRows rows(const std::vector<std::string>& columns,
                                    std::size_t /*number*/) override {
        return inner_->rows(columns, 0);
    }
    [[nodiscard]] std::vector<ViewColumn> measurements() override { return inner_->measurements(); }
    [[nodiscard]] ViewWork work() override { return inner_->work(); }
    [[nodiscard]] std::vector<std::filesystem::path> files() const override {
        return inner_->files();
    }

    std::latch asked{1};
    std::latch open{1};

  private:
    std::unique_ptr<ViewSubject> inner_ = viewed_subject();
};

/// Asks until it is computed.
HttpAnswer drawn(ViewPage& page, const json& request) {
    for (;;) {
        HttpAnswer answer = post(page, "picture", request);
        if (answer.status != 202) return answer;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
}

TEST(ViewPage, APictureHasTheBytesOfAStillOfTheRun) {
    const ScratchFolder folder;
    const auto run = viewed_run(folder.path());
    const auto subject = stored_subject(run, 1, {});
    ViewPage page(*subject, {});
    const HttpAnswer picture =
        post(page, "picture",
             {{"moment", 1}, {"width", 80}, {"height", 60}, {"settings", {"camera.azimuth=140"}}});
    EXPECT_EQ(picture.status, 200);
    EXPECT_EQ(picture.type, "image/png");
    ASSERT_EQ(fumon({"still", "run", "--step", "4", "-o", "still.png", "-q", "--set",
                     "camera.azimuth=140", "--set", "image.width=80", "--set", "image.height=60"},
                    folder.path())
                  .status,
              0);
    EXPECT_TRUE(picture.body == read_text(folder / "still.png"));
}

TEST(ViewPage, APictureFromAPlaceHasTheBytesOfAStillWithItsSettings) {
    const ScratchFolder folder;
    const auto run = viewed_run(folder.path());
    const auto subject = stored_subject(run, 1, {});
    ViewPage page(*subject, {});
    const HttpAnswer picture =
        post(page, "picture", {{"moment", 3}, {"eye", {5, -20, 25}}, {"target", {20, 15, 0}}});
    ASSERT_EQ(picture.status, 200);
    std::vector<std::string> still{"still", "run", "--step", "12", "-o", "still.png", "-q"};
    for (const auto& setting : json::parse(picture.headers.at("X-Fumon-Camera"))) {
        still.emplace_back("--set");
        still.push_back(setting);
    }
    ASSERT_EQ(fumon(still, folder.path()).status, 0);
    EXPECT_TRUE(picture.body == read_text(folder / "still.png"));
}

TEST(ViewPage, ASceneIsComputedAsFarAsOneLooks) {
    const ScratchFolder folder;
    const auto subject = viewed_subject();
    ViewPage page(*subject, {});
    json progress = read(get(page, "progress"));
    EXPECT_EQ(progress["state"], "computed");
    EXPECT_EQ(progress["moments"].size(), 13U);
    EXPECT_FALSE(progress["moments"][1]["ready"]);
    const HttpAnswer picture = drawn(page, {{"moment", 8}});
    progress = read(get(page, "progress"));
    EXPECT_TRUE(progress["moments"][8]["ready"]);
    EXPECT_FALSE(progress["moments"][9]["ready"]);
    write_text(folder / "viewed.toml", viewed_scene);
    ASSERT_EQ(fumon({"still", "viewed.toml", "--step", "8", "-o", "still.png", "-q"}, folder.path())
                  .status,
              0);
    EXPECT_TRUE(picture.body == read_text(folder / "still.png"));
}

TEST(ViewPage, DraftsAreSmallAndFollowTheCamera) {
    const auto subject = viewed_subject();
    ViewPage page(*subject, {});
    const auto draft = [&](const char* azimuth) {
        return post(page, "picture",
                    {{"draft", true},
                     {"width", 48},
                     {"height", 48},
                     {"settings", {std::string("camera.azimuth=") + azimuth}}});
    };
    const HttpAnswer first = draft("10");
    const HttpAnswer second = draft("60");
    const HttpAnswer again = draft("10");
    EXPECT_EQ(first.type, "image/jpeg");
    EXPECT_TRUE(first.body != second.body);
    EXPECT_TRUE(first.body == again.body);
}

TEST(ViewPage, OneRequestOfAClientIsDrawn) {
    GatedSubject subject;
    ViewPage page(subject, {});
    std::thread busy([&] { post(page, "picture", {{"client", "a"}, {"moment", 1}}); });
    subject.asked.wait();
    std::array<int, 2> statuses{};
    std::counting_semaphore<2> answered(0);
    const auto request = [&](int& status) {
        status = post(page, "picture", {{"client", "b"}}).status;
        answered.release();
    };
    std::thread one(request, std::ref(statuses[0]));
    std::thread other(request, std::ref(statuses[1]));
    EXPECT_TRUE(answered.try_acquire_for(std::chrono::seconds(30)));  // the older one, undrawn
    subject.open.count_down();
    for (std::thread* thread : {&busy, &one, &other}) thread->join();
    std::ranges::sort(statuses);
    EXPECT_EQ(statuses, (std::array{200, 204}));
}

TEST(ViewPage, ADraftWaitsForNoPicture) {
    GatedSubject subject;
    ViewPage page(subject, {});
    std::thread busy([&] { post(page, "picture", {{"client", "a"}, {"moment", 1}}); });
    subject.asked.wait();
    const json small = {{"client", "b"}, {"draft", true}, {"width", 48}, {"height", 48}};
    EXPECT_EQ(post(page, "picture", small).status, 200);
    subject.open.count_down();
    busy.join();
}

TEST(ViewPage, GivesUpThePicturesThatWait) {
    GatedSubject subject;
    ViewPage page(subject, {});
    std::thread busy([&] { post(page, "picture", {{"client", "a"}, {"moment", 1}}); });
    subject.asked.wait();
    int status = 0;
    std::thread waits([&] { status = post(page, "picture", {{"client", "b"}}).status; });
    page.cancel_all();
    waits.join();  // while the first is being drawn
    EXPECT_EQ(status, 204);
    subject.open.count_down();
    busy.join();
}

TEST(ViewPage, TellsOfEveryKeyOfTheLook) {
    const auto subject = viewed_subject("[sun]\nelevation = 50\n");
    ViewPage page(*subject, {});
    const json told = read(get(page, "subject"));
    EXPECT_EQ(told["title"], "Viewed");
    bool found = false;
    for (const json& key : told["keys"]) {
        EXPECT_EQ(key["section"] == "model", key.contains("fixed"));
        EXPECT_NE(key["key"], "look.drape");
        EXPECT_FALSE(key["help"].get<std::string>().empty()) << key["key"];
        if (key["key"] != "sun.elevation") continue;
        found = true;
        EXPECT_EQ(key["value"], "50.0");
        EXPECT_EQ(key["default"], "24.0");
        EXPECT_EQ(key["unit"], "degrees");
        EXPECT_EQ(key["maximum"], 90.0);
    }
    EXPECT_TRUE(found);
}

TEST(ViewPage, SaysWhatCheckSaysOfAWrongValue) {
    const ScratchFolder folder;
    const auto subject = viewed_subject();
    ViewPage page(*subject, {});
    write_text(folder / "viewed.toml", viewed_scene);
    for (const char* setting : {"sun.elevation=200", "camera.projection=round", "look.colour=1",
                                "camera.at=[1,2]", "image.supersampling=3"}) {
        const json fault = read(post(page, "check", {{"settings", {setting}}}));
        const auto checked =
            fumon({"check", "viewed.toml", "--set", setting}, folder.path()).errors;
        EXPECT_TRUE(contains(checked, fault.value("fault", "no fault"))) << fault << checked;
    }
    EXPECT_TRUE(read(post(page, "check", {{"settings", {"sun.elevation=20"}}})).empty());
}

TEST(ViewPage, ChangesNothingButTheLook) {
    const auto subject = viewed_subject();
    ViewPage page(*subject, {});
    for (const char* setting :
         {"model.creep_rate=0.1", "run.steps=5", "bed.file=/etc/passwd", "look.drape=/etc/passwd",
          "layer.0.file=/etc/passwd", "image.words=[\"/etc/passwd\"]", "output.frames=true"}) {
        EXPECT_THROW(post(page, "picture", {{"settings", {setting}}}), InputError) << setting;
        EXPECT_TRUE(read(post(page, "check", {{"settings", {setting}}})).contains("fault"));
    }
    const json large = {{"settings", {"image.width=16384", "image.height=16384"}}};
    EXPECT_TRUE(read(post(page, "check", large)).contains("fault"));
    EXPECT_THROW(post(page, "picture", {{"width", 16384}, {"height", 16384}}), InputError);
    ViewOptions options;
    options.trust = true;
    ViewPage trusting(*subject, options);
    EXPECT_TRUE(read(post(trusting, "check", large)).empty());
}

TEST(ViewPage, ServesItsOwnFilesAlone) {
    const auto subject = viewed_subject();
    ViewPage page(*subject, {});
    EXPECT_TRUE(contains(get(page, "").body, "<!DOCTYPE html>"));
    for (const char* name :
         {"view.css", "view.js", "server.js", "state.js", "stage.js", "camera.js", "settings.js",
          "presets.js", "terrain.js", "job.js", "watch.js", "take.js", "plots.js", "icon.svg"})
        EXPECT_EQ(get(page, name).status, 200) << name;
    for (const char* name : {"../view.js", "view.html", "/etc/passwd", "../../etc/passwd",
                             "watch.html", "./view.js", "view.js/", "..", "view.js%00"})
        EXPECT_EQ(get(page, name).status, 404) << name;
}

TEST(ViewPage, RefusesBodiesThatNoPageSends) {
    const auto subject = viewed_subject();
    ViewPage page(*subject, {});
    for (const char* body : {"", "[]", "{", "{\"moment\":-1}", "{\"moment\":\"x\"}",
                             "{\"moment\":99}", "{\"settings\":1}", "{\"settings\":[1]}",
                             "{\"eye\":[1,2]}", "{\"eye\":[1,2,3],\"target\":[1e300,2,3]}",
                             "{\"width\":99999}", "{\"settings\":[\"camera.azimuth\"]}"})
        EXPECT_THROW(page.answer({"POST", "picture", {}, body}), InputError) << body;
}

TEST(ViewPage, SavesOnlyIntoItsFolder) {
    const ScratchFolder folder;
    const auto subject = viewed_subject();
    ViewPage handing(*subject, {});
    const HttpAnswer handed = post(handing, "still", {{"name", "my still.png"}});
    EXPECT_EQ(handed.headers.at("Content-Disposition"), "attachment; filename=\"my still.png\"");
    EXPECT_EQ(handed.type, "image/png");

    ViewOptions options;
    options.save = folder / "saved";
    std::filesystem::create_directory(options.save);
    ViewPage page(*subject, options);
    for (const char* name : {"../x.png", "/tmp/x.png", "a/b.png", ".x.png", "x", "x.exe", "x.toml",
                             "", "a\n.png", "a\".png"})
        EXPECT_THROW(post(page, "still", {{"name", name}}), InputError) << name;
    EXPECT_TRUE(std::filesystem::is_empty(options.save));
    EXPECT_EQ(read(post(page, "still", {{"name", "x.jpg"}}))["saved"],
              (options.save / "x.jpg").string());
    EXPECT_EQ(post(page, "still", {{"name", "x.jpg"}}).status, 200);  // its own
    write_text(options.save / "theirs.toml", "a letter");
    EXPECT_THROW(post(page, "scene", {{"name", "theirs.toml"}}), InputError);
    EXPECT_EQ(read_text(options.save / "theirs.toml"), "a letter");
}

TEST(ViewPage, SavesASceneAndAFilmThatCommandsTake) {
    const ScratchFolder folder;
    const auto run = viewed_run(folder.path());
    const auto subject = stored_subject(run, 1, {});
    ViewOptions options;
    options.save = folder.path();
    ViewPage page(*subject, options);
    const json settings = {"look.colour_by=height", "camera.azimuth=100"};
    post(page, "scene", {{"name", "scene.toml"}, {"settings", settings}});
    ASSERT_EQ(fumon({"check", "scene.toml"}, folder.path()).status, 0);
    EXPECT_TRUE(contains(read_text(folder / "scene.toml"), "colour_by = \"height\""));
    const json keys = {{{"step", 0}, {"eye", {0, -20, 25}}, {"target", {20, 15, 0}}},
                       {{"step", 8}, {"eye", {40, -20, 25}}, {"target", {20, 15, 0}}}};
    const json shots = {{{"seconds", 2}, {"keys", keys}}};
    post(page, "film", {{"name", "film.toml"}, {"settings", settings}, {"shots", shots}});
    const Film film = parse_film(read_text(folder / "film.toml"), "film.toml");
    ASSERT_EQ(film.shots.size(), 1U);
    EXPECT_EQ(film.shots[0].keys.size(), 2U);
    EXPECT_EQ(film.shots[0].move, Move::keys);
    EXPECT_EQ(film.shots[0].to.value, 8.0);
    EXPECT_EQ(film.looks.size(), 1U);
    EXPECT_EQ(fumon({"check", "film.toml", "--run", "run"}, folder.path()).status, 0);
    EXPECT_THROW(post(page, "film", {{"name", "none.toml"}, {"shots", json::array()}}), InputError);
}

TEST(ViewPage, TellsTheMeasurementsUpToWhereTheRunIs) {
    const ScratchFolder folder;
    const auto run = viewed_run(folder.path());
    const auto stored = stored_subject(run, 1, {});
    const auto computed = viewed_subject();
    for (ViewSubject* subject : {stored.get(), computed.get()}) {
        ViewPage page(*subject, {});
        const json columns = read(get(page, "measurements"));
        ASSERT_GT(columns.size(), 2U);
        EXPECT_EQ(columns[0]["name"], "step");
        EXPECT_EQ(columns[0]["values"][0], 0.0);
        EXPECT_EQ(columns[0]["values"].size(), columns[2]["values"].size());
    }
}

}  // namespace
}  // namespace fumon
