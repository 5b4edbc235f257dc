#include "picture/baseline.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "support/pictures.h"
#include "support/temporary_folder.h"

namespace fumon {
namespace {

using test::message_of;
using test::some_picture;
using test::TemporaryFolder;

const std::string three_cases =
    "# Dunes, as they were accepted\n"
    "scene = \"dunes.toml\"\n"
    "settings = [\"image.width=320\"]\n"
    "step = 40\n"
    "\n"
    "[cases]\n"
    "perspective = {}                       # the usual look\n"
    "map = {step = 50, settings = [\"camera.projection=map\"], picture = true}\n"
    "at_time = {scene = \"other.toml\", time = 2.5, tile_ssim = 0.8, thumbnail_difference = 2}\n";

BaselineRecord some_record(int width) {
    BaselineRecord record;
    record.fumon = "0.1.0";
    record.environment = opengl_environment("osmesa", "llvmpipe (LLVM 15.0.6, 256 bits)",
                                            "4.5 (Core Profile) Mesa 22.3.6", true);
    record.state = std::string(64, 'a');
    record.fingerprint = fingerprint_of(some_picture(width, 30));
    return record;
}

Baseline read(const std::string& text) {
    const TemporaryFolder folder;
    return read_baseline(folder.file("b.toml", text));
}

/// The message without the folder.
std::string fault(const std::string& text) {
    const TemporaryFolder folder;
    const auto file = folder.file("b.toml", text);
    const std::string message = message_of<InputError>([&] { read_baseline(file); });
    return message.starts_with(folder.path().string())
               ? message.substr(folder.path().string().size() + 1)
               : message;
}

TEST(Baseline, CasesTakeWhatHoldsForAllAndKeepTheirOrder) {
    const Baseline baseline = read(three_cases);
    ASSERT_EQ(baseline.cases.size(), 3U);
    EXPECT_EQ(baseline.head, three_cases);

    const BaselineCase& perspective = baseline.cases[0];
    EXPECT_EQ(perspective.name, "perspective");
    EXPECT_EQ(perspective.scene, "dunes.toml");
    EXPECT_EQ(perspective.settings, std::vector<std::string>{"image.width=320"});
    EXPECT_EQ(perspective.step, 40);
    EXPECT_FALSE(perspective.picture);
    EXPECT_EQ(perspective.tile_ssim, same_to_the_eye_limits.tile_ssim);
    EXPECT_EQ(perspective.thumbnail_difference, same_to_the_eye_limits.thumbnail);

    const BaselineCase& map = baseline.cases[1];
    EXPECT_EQ(map.name, "map");
    EXPECT_EQ(map.settings, (std::vector<std::string>{"image.width=320", "camera.projection=map"}));
    EXPECT_EQ(map.step, 50);
    EXPECT_TRUE(map.picture);
    EXPECT_EQ(baseline.picture_of(map).filename(), "map.png");
    EXPECT_EQ(baseline.picture_of(map).parent_path().filename(), "b");

    const BaselineCase& at_time = baseline.cases[2];
    EXPECT_EQ(at_time.scene, "other.toml");
    EXPECT_EQ(at_time.time, 2.5);
    EXPECT_LT(at_time.step, 0) << "a time of its own takes the place of the common step";
    EXPECT_EQ(at_time.tile_ssim, 0.8);
    EXPECT_EQ(at_time.thumbnail_difference, 2.0);
}

/// A folder with b.toml and its lock.
struct Locked {
    explicit Locked(const std::string& lock) {
        file = folder.file("b.toml", three_cases);
        folder.file("b.lock", lock);
    }
    TemporaryFolder folder;
    std::filesystem::path file;
};

void expect_equal(const BaselineRecords& records, const BaselineRecords& expected) {
    EXPECT_EQ(records.size(), expected.size());
    for (const auto& [name, record] : expected) {
        EXPECT_EQ(records.at(name).fumon, record.fumon);
        EXPECT_EQ(records.at(name).environment, record.environment);
        EXPECT_EQ(records.at(name).state, record.state);
        EXPECT_EQ(records.at(name).fingerprint, record.fingerprint);
    }
}

TEST(Baseline, ItsLockWrittenAndReadAgainIsTheSame) {
    const BaselineRecords records{{"perspective", some_record(50)}, {"map", some_record(40)}};
    const std::string text = lock_text(records, LockOwner::verify);
    const Locked written(text);
    const Baseline again = read_baseline(written.file);
    expect_equal(again.records, records);
    EXPECT_EQ(lock_text(again.records, LockOwner::verify), text);
    EXPECT_FALSE(again.unlocked);
    EXPECT_EQ(again.head, three_cases) << "what people wrote";
    EXPECT_LT(text.find("[recorded.map]"), text.find("[recorded.perspective]")) << "by name";
}

TEST(Baseline, WhatHasNoCaseIsAnOrphan) {
    const Locked more(
        lock_text({{"map", some_record(40)}, {"oblique", some_record(40)}}, LockOwner::verify));
    const Baseline baseline = read_baseline(more.file);
    ASSERT_EQ(baseline.orphans.size(), 1U);
    EXPECT_TRUE(baseline.orphans.contains("oblique"));
    EXPECT_EQ(baseline.records.size(), 1U);
}

TEST(Baseline, RecordsThatStandInTheFileItselfAreReadAsBefore) {
    const BaselineRecords records{{"map", some_record(40)}};
    const std::string recorded = record_text("map", records.at("map"));
    const std::string old =
        three_cases +
        "\n# Recorded by `fumon verify --update`, which writes anew all that follows.\n\n" +
        recorded;
    const Baseline baseline = read(old);
    EXPECT_TRUE(baseline.unlocked);
    EXPECT_EQ(baseline.head, three_cases) << "without what goes into the lock";
    expect_equal(baseline.records, records);

    const TemporaryFolder folder;
    const auto file = folder.file("b.toml", old);
    const auto lock = folder.file("b.lock", lock_text(records, LockOwner::verify));
    EXPECT_EQ(
        message_of<InputError>([&] { read_baseline(file); }),
        file.string() + ":13:1: recorded values belong in " + lock.string() + "; remove them here");
}

TEST(Baseline, ALockBelongsToWhoWroteIt) {
    const Locked other(lock_text({}, LockOwner::pytest));
    const std::string message = message_of<InputError>([&] { read_baseline(other.file); });
    EXPECT_TRUE(
        message.ends_with("b.lock:1:1: was recorded by pytest; rename the baseline, whose "
                          "lock bears its name"))
        << message;
    EXPECT_TRUE(message_of<InputError>([&] {
                    read_baseline(std::filesystem::path(other.file).replace_extension(".lock"));
                }).ends_with("b.lock: is a lock file; name its baseline"));
    const Locked damaged("[recorded.map]\nsize = 3\n");
    EXPECT_NE(message_of<InputError>([&] { read_baseline(damaged.file); }).find("b.lock:2:8: "),
              std::string::npos);
}

TEST(Baseline, ACaseHasRecordsOfItsEnvironments) {
    const std::string described =
        "environments = [\"card\", \"mesa-22\"]\n[environment.mesa-22]\nmesa = \"22.3\"\n"
        "drawer = \"software\"\n[environment.card]\ndrawer = \"gpu\"\n[cases]\n"
        "map = {scene = \"s.toml\"}\n";
    const TemporaryFolder folder;
    const auto file = folder.file("b.toml", described);
    const BaselineRecords records{
        {"map", some_record(40)}, {"map@card", some_record(41)}, {"map@gone", some_record(42)}};
    const std::string text = lock_text(records, LockOwner::verify);
    folder.file("b.lock", text);
    const Baseline baseline = read_baseline(file);
    EXPECT_EQ(baseline.records.size(), 2U);
    EXPECT_TRUE(baseline.orphans.contains("map@gone")) << "the case does not name it";
    EXPECT_EQ(lock_text(read_lock(baseline.lock(), LockOwner::verify), LockOwner::verify), text);
    EXPECT_EQ(baseline.picture_of("map@card").filename(), "map@card.png");

    const BaselineCase& map = baseline.cases.front();
    const auto name_in = [&](const char* renderer, const char* version) {
        const auto here = opengl_environment("egl", renderer, version, false);
        const NamedEnvironment* found = baseline.environment_of(map, here);
        return found == nullptr ? "" : found->name;
    };
    EXPECT_EQ(name_in("llvmpipe (LLVM 15.0.6, 256 bits)", "4.5 Mesa 22.3.6"), "mesa-22");
    EXPECT_EQ(name_in("llvmpipe (LLVM 15.0.6, 256 bits)", "4.5 Mesa 22.30.1"), "");
    EXPECT_EQ(name_in("NVIDIA H100", "4.6.0 NVIDIA 535"), "card");
    EXPECT_EQ(baseline.environment_of(map, {}), nullptr) << "nothing is known of it";

    EXPECT_EQ(fault("environments = [\"a\"]\n[cases]\nmap = {scene = \"s.toml\"}\n"),
              "b.toml:1:16: environments names \"a\", which has no description; write "
              "[environment.a] with its mesa, driver or drawer");
    EXPECT_EQ(fault("[environment.a]\n[cases]\nmap = {scene = \"s.toml\"}\n"),
              "b.toml:1:14: environment.a matches any machine; give its mesa, driver or drawer");
}

TEST(Baseline, AWrongCaseMayBeKeptWithItsFault) {
    const TemporaryFolder folder;
    const auto file = folder.file(
        "b.toml", "[cases]\na = {scene = \"s.toml\"}\nb = {scene = \"s.toml\", stop = 3}\n");
    const Baseline baseline = read_baseline(file, WrongCases::kept);
    ASSERT_EQ(baseline.cases.size(), 2U);
    EXPECT_EQ(baseline.cases[0].fault, "");
    EXPECT_EQ(baseline.cases[1].fault,
              file.string() + ":3:24: unknown key cases.b.stop; did you mean \"cases.b.step\"?");
    folder.file("b.lock", "[recorded.a]\nsize = 3\n");
    const Baseline damaged = read_baseline(file, WrongCases::kept);
    EXPECT_NE(damaged.cases[0].fault.find("b.lock:2:8: "), std::string::npos);
}

TEST(Baseline, FaultsAreLocated) {
    EXPECT_EQ(fault("scene = \"a.toml\"\n"),
              "b.toml:1:1: names no case; write [cases] and below NAME = {scene = \"FILE.toml\"}");
    EXPECT_EQ(fault("[cases]\na = {}\n"),
              "b.toml:2:1: cases.a.scene is missing; name a scene file (TOML)");
    EXPECT_EQ(fault("[cases]\na = {scene = 3}\n"),
              "b.toml:2:14: cases.a.scene is 3; it takes a text in quotes");
    EXPECT_EQ(fault("[cases]\na = {scene = \"s\", stepp = 3}\n"),
              "b.toml:2:19: unknown key cases.a.stepp; did you mean \"cases.a.step\"?");
    EXPECT_EQ(fault("[cases]\na = {scene = \"s\", step = -1}\n"),
              "b.toml:2:26: cases.a.step is -1; it takes a whole number 0 … 1e+15 (steps)");
    EXPECT_EQ(fault("[cases]\na = {scene = \"s\", step = 1, time = 2}\n"),
              "b.toml:2:1: cases.a has a step and a time; keep one");
    EXPECT_EQ(fault("[cases]\n\"../a\" = {scene = \"s\"}\n"),
              "b.toml:2:1: the name of a case takes letters, digits, \"-\" and \"_\"");
    EXPECT_EQ(fault("[cases]\na = 3\n"),
              "b.toml:2:5: cases.a is not a section; it takes {scene = \"FILE.toml\", …}");
    EXPECT_EQ(fault("cases = 3\n"),
              "b.toml:1:9: cases is a section; write [cases] and its keys below");
    EXPECT_EQ(fault("[cases\n").substr(0, 11), "b.toml:1:7:");
    EXPECT_EQ(fault("[recorded.a]\nfumon = \"0\"\n[cases]\na = {scene = \"s\"}\n"),
              "b.toml:4:1: cases.a comes after the recorded values; move it up");
    EXPECT_EQ(fault("[cases]\na = {scene = \"s\"}\n[recorded.a]\ncolour = 1\n").substr(0, 42),
              "b.toml:4:1: unknown key recorded.a.colour;");
    EXPECT_EQ(fault("[cases]\na = {scene = \"s\"}\n[recorded.a]\nfumon = \"0\"\n"),
              "b.toml:3:1: recorded.a.size takes [width, height]");
}

TEST(Baseline, AMissingFileIsOneLine) {
    const std::string message = message_of<InputError>([] { read_baseline("no.toml"); });
    EXPECT_TRUE(message.starts_with("no.toml: cannot be read")) << message;
}

}  // namespace
}  // namespace fumon
