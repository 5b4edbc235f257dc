#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "support/program.h"
#include "support/raw_http.h"
#include "support/viewed_run.h"

namespace fumon {
namespace {

using nlohmann::json;
using test::contains;
using test::ScratchFolder;
using test::write_text;

/// A program that serves a page, and its address.
class ServingProgram {
  public:
    ServingProgram(const std::vector<std::string>& words, const std::filesystem::path& folder)
        : program_(words, folder) {
        for (int i = 0; i < 600 && !contains(program_.output(), "ssh -L"); ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
        const std::string said = program_.output();
        const std::string begin = "http://127.0.0.1:";
        if (!said.starts_with(begin)) return;
        port_ = std::stoi(said.substr(begin.size()));
        base_ = said.substr(said.find('/', begin.size()));
        base_.erase(base_.find('\n'));
    }

    [[nodiscard]] std::string get(const std::string& path) const {
        return ask(port_, "GET", base_ + path);
    }
    [[nodiscard]] std::string post(const std::string& path, const std::string& body) const {
        return ask(port_, "POST", base_ + path, "127.0.0.1", "", body);
    }
    /// The job's state once it holds what is sought.
    [[nodiscard]] json job_when(bool (*holds)(const json&)) const {
        json state;
        for (int i = 0; i < 1200; ++i) {
            state = json::parse(body_of(get("job?client=test&last=1")), nullptr, false);
            if (!state.is_discarded() && holds(state)) break;
            std::this_thread::sleep_for(std::chrono::milliseconds(25));
        }
        return state;
    }
    [[nodiscard]] test::Program& program() { return program_; }
    [[nodiscard]] int port() const { return port_; }
    [[nodiscard]] const std::string& base() const { return base_; }

  private:
    test::Program program_;
    int port_ = 0;
    std::string base_;
};

bool has_ended(const json& job) {
    return !job["outcome"].get<std::string>().empty();
}

TEST(WatchedJob, ARunTellsHowFarItIsAndStopsAsByCtrlC) {
    const ScratchFolder folder;
    write_text(folder / "viewed.toml", viewed_scene);
    ServingProgram run({"run", "viewed.toml", "-o", "run", "-q", "--view", "--set",
                        "run.steps=100000000", "--set", "output.fields_every=0"},
                       folder.path());
    const json job = run.job_when(
        [](const json& now) { return !now["stages"].empty() && now["stages"][0]["done"] > 0; });
    EXPECT_EQ(job["stages"][0]["name"], "steps");
    EXPECT_EQ(job["stages"][0]["all"], 100000000);
    EXPECT_EQ(job["outcome"], "");
    const json subject = json::parse(body_of(run.get("subject")));
    EXPECT_TRUE(subject["job"]);
    EXPECT_EQ(subject["state"], "running");
    EXPECT_TRUE(contains(run.get(""), "<!DOCTYPE html>"));
    json progress;
    for (int i = 0; i < 400; ++i) {  // it is asked for the newest state
        progress = json::parse(body_of(run.get("progress")));
        if (progress["moments"].size() > 1) break;
        std::this_thread::sleep_for(std::chrono::milliseconds(25));
    }
    EXPECT_GT(progress["moments"].size(), 1U);
    EXPECT_EQ(body_of(run.post("stop", "{}")), "stopping");
    const json end = run.job_when(has_ended);
    EXPECT_TRUE(contains(end["outcome"], "; fumon run --resume run goes on from step ")) << end;
    EXPECT_EQ(run.program().wait().status, 130);
    EXPECT_TRUE(std::filesystem::exists(folder / "run" / "checkpoint.fumon"));
}

TEST(WatchedJob, TellsThePageHowARunEnded) {
    const ScratchFolder folder;
    write_text(folder / "viewed.toml", viewed_scene);
    ServingProgram run(
        {"run", "viewed.toml", "-o", "run", "-q", "--view", "--set", "run.steps=3000"},
        folder.path());
    EXPECT_EQ(run.job_when(has_ended)["outcome"], "complete: 3,000 steps; fumon view run");
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_EQ(run.program().wait().status, 0);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(4));
}

TEST(WatchedJob, AFilmShowsItsNewestFrame) {
    const ScratchFolder folder;
    viewed_run(folder.path());
    ServingProgram film({"film", "run", "-o", "film.mp4", "-q", "--view", "--set",
                         "film.size=320x180", "--set", "film.rate=60"},
                        folder.path());
    const json job = film.job_when([](const json& now) { return now["pictures"] > 0; });
    EXPECT_EQ(job["stages"][0]["name"], "frames");
    EXPECT_TRUE(contains(film.get("job-picture"), "Content-Type: image/jpeg"));
    EXPECT_TRUE(contains(film.get(""), "watch.js"));
    static_cast<void>(film.post("stop", "{}"));
    EXPECT_EQ(film.job_when(has_ended)["outcome"], "stopped");
    EXPECT_EQ(film.program().wait().status, 130);
    EXPECT_FALSE(std::filesystem::exists(folder / "film.mp4"));
}

TEST(WatchedJob, ASweepShowsItsGrid) {
    const ScratchFolder folder;
    write_text(folder / "viewed.toml", viewed_scene);
    ServingProgram sweep(
        {"sweep", "viewed.toml", "--over", "model.creep_rate=0.1,0.2", "--seeds", "2", "-o",
         "sweep", "-q", "--view", "--set", "run.steps=100000000", "--set", "output.fields_every=0"},
        folder.path());
    const json grid = json::parse(body_of(sweep.get("sweep")));
    EXPECT_EQ(grid["axes"][0]["label"], "model.creep_rate");
    EXPECT_EQ(grid["runs"].size(), 4U);
    static_cast<void>(sweep.post("stop", "{}"));
    EXPECT_TRUE(contains(sweep.job_when(has_ended)["outcome"], "the same command goes on"));
    EXPECT_EQ(sweep.program().wait().status, 130);
}

TEST(WatchedJob, APortThatIsTakenReplacesNothing) {
    const ScratchFolder folder;
    const auto run = viewed_run(folder.path());
    const std::string before = test::read_text(run / "run.json");
    const ServingProgram other({"view", "run"}, folder.path());
    const std::string port = std::to_string(other.port());
    EXPECT_EQ(
        test::fumon({"run", "viewed.toml", "-o", "run", "-q", "--force", "--view", "--port", port},
                    folder.path())
            .status,
        2);
    EXPECT_TRUE(test::read_text(run / "run.json") == before);
    EXPECT_TRUE(std::filesystem::exists(run / "fields.nc"));
    EXPECT_EQ(test::fumon({"sweep", "viewed.toml", "--seeds", "2", "-o", "s", "-q", "--view",
                           "--port", port},
                          folder.path())
                  .status,
              2);
    EXPECT_FALSE(std::filesystem::exists(folder / "s"));
}

TEST(WatchedJob, OfASweepThatIsSharedOutThereIsNone) {
    const ScratchFolder folder;
    write_text(folder / "viewed.toml", viewed_scene);
    EXPECT_EQ(
        test::fumon({"sweep", "viewed.toml", "--seeds", "2", "-o", "s", "--view", "--shard", "1/2"},
                    folder.path())
            .status,
        2);
    EXPECT_FALSE(std::filesystem::exists(folder / "s"));
}

TEST(Viewer, KeepsToItsPagesAndOutlivesClientsThatVanish) {
    const ScratchFolder folder;
    const auto run = viewed_run(folder.path());
    std::filesystem::permissions(run, std::filesystem::perms::owner_write,
                                 std::filesystem::perm_options::remove);
    ServingProgram one({"view", "run"}, folder.path());
    ServingProgram other({"view", "run"}, folder.path());  // of the same run
    for (const char* path : {"%2e%2e/%2e%2e/etc/passwd", "..%2f..%2fetc%2fpasswd", "../view.js",
                             "%2e%2e%5cview.js", "terrain/..%2f1/", "view.js%00", "terrain/1/"})
        EXPECT_EQ(status_of(one.get(path)), "404") << path;
    EXPECT_EQ(status_of(ask(one.port(), "GET", "/%2e%2e" + one.base())), "403");
    EXPECT_EQ(status_of(ask(one.port(), "GET", one.base(), "evil.example")), "403");
    EXPECT_EQ(status_of(ask(one.port(), "POST", one.base() + "stop", "127.0.0.1",
                            "Origin: http://evil.example\r\n", "{}")),
              "403");
    const std::string body = R"({"moment":3,"width":320,"height":180})";
    for (int i = 0; i < 5; ++i) {
        const RawConnection vanishes(one.port());
        vanishes.send("POST " + one.base() +
                      "picture HTTP/1.1\r\nHost: localhost\r\nContent-Length: " +
                      std::to_string(body.size()) + "\r\n\r\n" + body);
    }
    EXPECT_TRUE(body_of(one.post("picture", body)) == body_of(other.post("picture", body)));
    std::filesystem::permissions(run, std::filesystem::perms::owner_write,
                                 std::filesystem::perm_options::add);
}

}  // namespace
}  // namespace fumon
