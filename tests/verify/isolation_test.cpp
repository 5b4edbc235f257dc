#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <optional>
#include <sstream>
#include <thread>
#include <vector>

#include "support/full_disk.h"
#include "support/html_page.h"
#include "support/verify_folder.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;

void wait_a_moment() {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
}

/// A child of a process, or 0.
int child_of(int parent) {
    for (const auto& entry : fs::directory_iterator("/proc")) {
        const std::string name = entry.path().filename();
        if (name.find_first_not_of("0123456789") != std::string::npos) continue;
        const std::string status = read_text(entry.path() / "stat");
        const std::size_t behind_name = status.rfind(')');
        if (behind_name == std::string::npos) continue;
        std::istringstream fields(status.substr(behind_name + 1));
        char state = ' ';
        int its_parent = 0;
        fields >> state >> its_parent;
        if (its_parent == parent && state != 'Z') return std::stoi(name);
    }
    return 0;
}

/// Of three cases the second would take days.
class VerifyIsolation : public ::testing::Test, public VerifyFolder {
  protected:
    VerifyIsolation() {
        write_baseline("b.toml",
                       "first = {}\nendless = {step = 1000000000, settings = "
                       "[\"run.steps=1000000000\", \"output.measure_every=1000000000\"]}\n"
                       "last = {}\n");
    }

    /// Starts it and waits until it is at the second case; its child.
    int start() {
        program_.emplace(std::vector<std::string>{"verify", "b.toml", "--trust", "-o", "out",
                                                  "--junit", "j.xml"},
                         folder_.path());
        for (int tries = 0; tries < 3000 && !has("out/b/first-got.png"); ++tries) wait_a_moment();
        EXPECT_TRUE(has("out/b/first-got.png"));
        return child_of(program_->process());
    }

    void expect_whole() const {
        EXPECT_TRUE(text("out/index.html").ends_with("</html>\n"));
        EXPECT_EQ(faults_of_page(text("out/index.html")), std::vector<std::string>{});
        EXPECT_FALSE(has("out/index.html.part"));
        EXPECT_TRUE(text("j.xml").ends_with("</testsuites>\n"));
    }

    std::optional<Program> program_;
};

TEST_F(VerifyIsolation, ACrashIsTheErrorOfItsCaseAndTheOthersAreCompared) {
#ifdef FUMON_SANITIZED
    const std::vector<int> signals{SIGKILL};  // sanitizers end of others with a status
#else
    const std::vector<int> signals{SIGSEGV, SIGKILL};
#endif
    for (const int signal : signals) {
        fs::remove(folder_ / "j.xml");
        fs::remove_all(folder_ / "out");
        const int child = start();
        ASSERT_GT(child, 0);
        // What a program sends is told at once and ends at the second; a fault comes again by
        // itself.
        for (int tries = 0; tries < 500 && kill(child, signal) == 0 && !has("out/b/last-got.png");
             ++tries)
            wait_a_moment();
        const Ended ended = program_->wait();
        EXPECT_EQ(ended.status, 3) << ended.output;
        EXPECT_TRUE(
            contains(ended.output, "FAILED   b endless: the process that drew it crashed: signal " +
                                       std::to_string(signal)))
            << ended.output;
        EXPECT_TRUE(contains(ended.output, "MISSING  b last: ")) << "by a new child";
        EXPECT_TRUE(contains(text("j.xml"), "tests=\"3\" failures=\"2\" errors=\"1\""));
        EXPECT_TRUE(contains(text("out/index.html"), "crashed: signal "));
        expect_whole();
    }
}

TEST_F(VerifyIsolation, ASignalEndsItWithReportAndPage) {
    for (const int signal : {SIGTERM, SIGINT}) {
        fs::remove_all(folder_ / "out");
        const int child = start();
        program_->send(signal);
        const Ended ended = program_->wait();
        EXPECT_EQ(ended.status, 3) << ended.output;
        EXPECT_TRUE(contains(ended.errors, ": 2 of 3 cases were not compared\n")) << ended.errors;
        EXPECT_TRUE(contains(text("j.xml"), "tests=\"3\" failures=\"1\" errors=\"2\""));
        EXPECT_TRUE(contains(text("j.xml"), "not compared: stopped by signal"));
        expect_whole();
        EXPECT_NE(kill(child, 0), 0) << "its child has ended, too";
    }
}

TEST_F(VerifyIsolation, InOneProcessItSaysTheSame) {
    write_baseline("b.toml", "first = {}\nsecond = {settings = [\"camera.projection=map\"]}\n");
    ASSERT_EQ(verify({"b.toml", "--update", "--pinned"}).status, 0);
    const Ended isolated = verify({"b.toml"});
    const Ended alone = verify({"b.toml", "--no-isolate"});
    EXPECT_EQ(isolated.status, 0);
    EXPECT_EQ(alone.output, isolated.output);
    EXPECT_EQ(alone.errors, isolated.errors);
}

TEST_F(VerifyIsolation, AnOldReportNeverSurvives) {
    write_baseline("b.toml", "first = {}\n");
    ASSERT_EQ(verify({"b.toml", "--junit", "j.xml"}).status, 1);
    fs::create_directories(folder_ / "site");
    write_text(folder_ / "site/index.html", "mine");
    const Ended refused = verify({"b.toml", "--junit", "j.xml", "-o", "site"});
    EXPECT_EQ(refused.status, 2);
    EXPECT_TRUE(contains(text("j.xml"), "site/index.html: already exists")) << text("j.xml");
    const Ended unknown = verify({"b.toml", "frist", "--junit", "j.xml"});
    EXPECT_EQ(unknown.errors, "no case is named \"frist\"; did you mean \"first\"?\n");
    EXPECT_TRUE(contains(text("j.xml"), "errors=\"1\"")) << text("j.xml");
}

TEST_F(VerifyIsolation, AFullDiskLeavesTextsAlone) {
    fs::create_directory(folder_ / "disk");
    const SmallDisk disk(folder_ / "disk", 100);
    if (!disk.mounted()) GTEST_SKIP() << "cannot mount a small tmpfs here (needs root)";
    write_baseline("b.toml", "first = {}\nsecond = {}\n",
                   "settings = [\"image.width=320\", \"image.height=240\"]\n");
    const Ended ended = verify({"b.toml", "-o", "disk/out", "--junit", "disk/j.xml"});
    EXPECT_EQ(ended.status, 3);
    EXPECT_TRUE(contains(ended.errors, "No space left on device")) << ended.errors;
    EXPECT_TRUE(contains(text("disk/j.xml"), "failures=\"2\"")) << ended.errors;
    const std::string page = text("disk/out/index.html");
    EXPECT_TRUE(page.ends_with("</html>\n"));
    EXPECT_TRUE(contains(page, "<h2>b first</h2>") && contains(page, "<h2>b second</h2>"));
    EXPECT_FALSE(has("disk/out/index.html.part"));
}

TEST_F(VerifyIsolation, WhereNoReportHasRoomTheReasonIsTold) {
    fs::create_directory(folder_ / "disk");
    const SmallDisk disk(folder_ / "disk", 64);
    if (!disk.mounted()) GTEST_SKIP() << "cannot mount a small tmpfs here (needs root)";
    write_baseline("b.toml", "first = {}\n");
    write_text(folder_ / "disk/filling", std::string(64 << 10, 'x'));
    const Ended ended = verify({"b.toml", "-o", "disk/out", "--junit", "disk/j.xml"});
    EXPECT_EQ(ended.status, 3);
    EXPECT_TRUE(contains(ended.errors, "No space left on device")) << ended.errors;
}

TEST_F(VerifyIsolation, ACheckoutThatMayOnlyBeReadTakesATemporaryFolder) {
    fs::create_directory(folder_ / "disk");
    fs::create_directory(folder_ / "temporary");
    const SmallDisk disk(folder_ / "disk", 2000);
    if (!disk.mounted()) GTEST_SKIP() << "cannot mount a small tmpfs here (needs root)";
    write_text(folder_ / "disk/scene.toml", small_scene());
    write_baseline("disk/good.toml", "first = {}\n");
    write_baseline("disk/new.toml", "first = {}\n");
    const auto there = [&](std::vector<std::string> words) {
        return fumon(words, folder_ / "disk", {"TMPDIR=" + (folder_ / "temporary").string()});
    };
    ASSERT_EQ(there({"verify", "good.toml", "--update"}).status, 0);
    ASSERT_EQ(mount("", (folder_ / "disk").c_str(), "", MS_REMOUNT | MS_RDONLY, nullptr), 0);
    const Ended good = there({"verify", "good.toml"});
    EXPECT_EQ(good.status, 0) << good.errors;
    EXPECT_EQ(good.errors, "");
    EXPECT_TRUE(fs::is_empty(folder_ / "temporary"));
    const Ended missing = there({"verify", "new.toml"});
    EXPECT_EQ(missing.status, 1) << missing.errors;
    EXPECT_TRUE(missing.errors.starts_with(
        "cannot make the folder verify-out: Read-only file system; results are in " +
        (folder_ / "temporary/fumon-verify-").string()))
        << missing.errors;
    EXPECT_FALSE(fs::is_empty(folder_ / "temporary"));
    const Ended named = there({"verify", "new.toml", "-o", "out"});
    EXPECT_EQ(named.status, 3);
    EXPECT_EQ(named.errors, "cannot make the folder out: Read-only file system\n");
}

}  // namespace
}  // namespace fumon::test
