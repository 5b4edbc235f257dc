#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <thread>

#include "picture/png.h"
#include "support/full_disk.h"
#include "support/program.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

constexpr const char* air_scene =
    "[model]\nname = \"airflow\"\nnz = 15\ntime_step = 1e-5\nlaunch_angles = [20.0, 40.0]\n"
    "[grid]\nnx = 100\ncell_size = 1e-4\n[run]\nsteps = 100\n";

/// A command that writes into the folder "disk".
struct Output {
    const char* name;
    Words words;
    int room = 8;  ///< KiB that a full disk leaves: for folders and a manifest
};

void PrintTo(const Output& output, std::ostream* out) {
    *out << output.name;
}

Output run_that_writes(const char* name, const Words& wanted) {
    Words words{"run", "scene.toml", "-o", "disk/out", "-q"};
    for (const char* other : {"frames", "movie", "measurements"})
        words.insert(words.end(), {"--set", std::string("output.") + other + "=false"});
    for (const std::string& setting : wanted) words.insert(words.end(), {"--set", setting});
    return {name, words};
}

class FaultTest : public ::testing::Test {
  protected:
    void SetUp() override {
        write_text(folder_ / "scene.toml", small_scene());
        write_text(folder_ / "air.toml", air_scene);
        fs::create_directory(folder_ / "disk");
    }

    /// Runs fumon, in a shell, as `"$FUMON" …`; the shell's line may say what surrounds it.
    Ended shell(const std::string& line) {
        const std::string command = "cd '" + folder_.path().string() + "' && FUMON='" +
                                    FUMON_PROGRAM + "' && { " + line + "; } > output 2> errors";
        const int status = std::system(command.c_str());
        return {WEXITSTATUS(status), read_text(folder_ / "output"), read_text(folder_ / "errors")};
    }

    void expect_one_line(const Ended& ended, int status, const std::string& what) {
        EXPECT_EQ(ended.status, status) << ended.errors;
        EXPECT_EQ(std::count(ended.errors.begin(), ended.errors.end(), '\n'), 1) << ended.errors;
        EXPECT_NE(ended.errors.find(what), std::string::npos) << ended.errors;
    }

    /// No file without its final name, and only whole pictures.
    void expect_whole_files(const fs::path& folder) {
        for (const auto& entry : fs::recursive_directory_iterator(folder)) {
            EXPECT_NE(entry.path().extension(), ".part") << entry.path();
            if (entry.path().extension() != ".png") continue;
            EXPECT_NO_THROW(read_png(entry.path())) << entry.path();
        }
    }

    ScratchFolder folder_;
};

class EveryOutput : public FaultTest, public ::testing::WithParamInterface<Output> {};

TEST_P(EveryOutput, AFullDiskIsOneLine) {
    const SmallDisk disk(folder_ / "disk", 32);
    if (!disk.mounted()) GTEST_SKIP() << "cannot mount a small tmpfs here (needs root)";
    const auto filling = static_cast<std::size_t>(32 - GetParam().room) << 10U;
    write_text(folder_ / "disk/filling", std::string(filling, 'x'));
    const Ended ended = fumon(GetParam().words, folder_.path());
    expect_one_line(ended, 3, "No space left on device");
    expect_whole_files(folder_ / "disk");
}

TEST_P(EveryOutput, AReadOnlyFolderIsOneLine) {
    const bool root = geteuid() == 0;
    const SmallDisk disk(folder_ / "disk", 64);
    if (root && !disk.mounted()) GTEST_SKIP() << "root, and cannot mount a disk here";
    if (root) {
        ASSERT_EQ(mount("", (folder_ / "disk").c_str(), "", MS_REMOUNT | MS_RDONLY, nullptr), 0);
    } else {
        fs::permissions(folder_ / "disk", fs::perms::owner_read | fs::perms::owner_exec);
    }
    const Ended ended = fumon(GetParam().words, folder_.path());
    if (!root) fs::permissions(folder_ / "disk", fs::perms::owner_all);
    expect_one_line(ended, 3, root ? "Read-only file system" : "Permission denied");
    EXPECT_TRUE(fs::is_empty(folder_ / "disk"));
}

TEST_P(EveryOutput, AFolderThatIsAFileIsOneLine) {
    fs::remove(folder_ / "disk");
    write_text(folder_ / "disk", "in the way");
    const Ended ended = fumon(GetParam().words, folder_.path());
    EXPECT_EQ(std::count(ended.errors.begin(), ended.errors.end(), '\n'), 1) << ended.errors;
    EXPECT_EQ(ended.status, 3) << ended.errors;
    EXPECT_EQ(read_text(folder_ / "disk"), "in the way");
}

INSTANTIATE_TEST_SUITE_P(
    Faults, EveryOutput,
    ::testing::Values(
        run_that_writes("Frames", {"output.frames=true", "image.width=640", "image.height=480"}),
        run_that_writes("Movie", {"output.movie=true", "image.width=640", "image.height=480"}),
        run_that_writes("Measurements",
                        {"output.measurements=true", "output.measure_every=1", "run.steps=200"}),
        run_that_writes("Beds", {"output.bed_every=5"}),
        run_that_writes("Fields", {"output.fields_every=5"}),
        Output{"Sweep", {"sweep", "scene.toml", "-o", "disk/out", "-q", "--seeds", "1"}, 0},
        Output{"Still",
               {"still", "scene.toml", "-o", "disk/out.png", "-q", "--step", "0", "--set",
                "image.width=640", "--set", "image.height=480"}},
        Output{"HopLaw", {"hop-law", "air.toml", "-o", "disk/out.toml", "-q"}, 0}),
    [](const auto& test) { return std::string(test.param.name); });

TEST_P(EveryOutput, ALimitOnTheSizeOfFilesIsOneLine) {
    std::string line = "ulimit -f 1; \"$FUMON\"";  // KiB or half as much, as the shell has it
    for (const std::string& word : GetParam().words) line += " '" + word + "'";
    const Ended ended = shell(line);
    expect_one_line(ended, 3, "File too large");
    expect_whole_files(folder_ / "disk");
}

TEST_F(FaultTest, TooManyOpenFilesAreNotCalledAFullDisk) {
    int failed = 0;
    for (int files = 5; files < 16; ++files) {
        const std::string out = "out" + std::to_string(files);
        const Ended ended = shell("ulimit -n " + std::to_string(files) +
                                  "; \"$FUMON\" run scene.toml -q -o " + out +
                                  " --set output.fields_every=5 --set output.bed_every=5 --set "
                                  "output.frames=false --set output.movie=false");
        if (ended.status == 0) continue;
        ++failed;
        expect_one_line(ended, 3, "Too many open files");
    }
    EXPECT_GT(failed, 2) << "the limits are too high to try anything";
}

TEST_F(FaultTest, AFullStandardOutputIsOneLine) {
    write_text(folder_ / "bed.asc", "ncols 2\nnrows 2\ncellsize 1\n1 2\n3 4\n");
    for (const char* words : {"measure bed.asc", "measure --json bed.asc", "check scene.toml",
                              "models", "describe", "describe --json"}) {
        const Ended ended = shell(std::string("\"$FUMON\" ") + words + " > /dev/full");
        expect_one_line(ended, 3, "cannot write to standard output: No space left on device");
    }
}

/// The exit status of a command whose standard error nobody reads.
constexpr const char* unread = " 2>&1 > /dev/null; echo $? > status; } | true; cat status; }";

TEST_F(FaultTest, ARunGoesOnWhenNobodyReadsItsMessages) {
    const Ended ended =
        shell(std::string("{ { sleep 0.2; \"$FUMON\" run scene.toml -o out -v") + unread);
    EXPECT_EQ(ended.output, "0\n");
    const auto manifest = read_manifest(folder_ / "out");
    EXPECT_EQ(manifest["status"], "complete");
    EXPECT_EQ(manifest["frames"].size(), 5U);
}

TEST_F(FaultTest, AMeasurementIsWrittenWhenNobodyReadsTheNoteBesideIt) {
    const std::string degrees = "ncols 2\nnrows 2\nxllcorner 139\nyllcorner 35\ncellsize 0.001\n";
    write_text(folder_ / "bed.asc", degrees + "1 2\n3 4\n");
    ASSERT_NE(shell("\"$FUMON\" measure bed.asc").errors, "") << "there is a note";
    const Ended ended = shell("\"$FUMON\" measure bed.asc 2> /dev/full");
    EXPECT_EQ(ended.status, 0);
    EXPECT_NE(ended.output.find("mean_height"), std::string::npos) << ended.output;
}

TEST_F(FaultTest, AListingEndsWithItsReader) {
    const Ended ended =
        shell("{ { sleep 0.2; \"$FUMON\" describe; echo $? > status; } | true; cat status; }");
    EXPECT_EQ(ended.output, "141\n") << "by SIGPIPE, as other programs do";
    EXPECT_EQ(ended.errors, "");
}

TEST_F(FaultTest, AFolderThatIsMovedAwayStopsARunAndKeepsItsFrames) {
    Program program({"run", "scene.toml", "-o", "out", "-q", "--set", "run.steps=100000000"},
                    folder_.path());
    for (int tries = 0; tries < 600 && !fs::exists(folder_ / "out/frames/frame_000002.png");
         ++tries)
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    fs::rename(folder_ / "out", folder_ / "moved");
    expect_one_line(program.wait(), 3, "No such file or directory");
    EXPECT_FALSE(fs::exists(folder_ / "out"));
    EXPECT_GE(std::distance(fs::directory_iterator(folder_ / "moved/frames"), {}), 3);
    for (const char* frame : {"frame_000000.png", "frame_000001.png", "frame_000002.png"})
        EXPECT_NO_THROW(read_png(folder_ / "moved/frames" / frame));
}

TEST_F(FaultTest, WithoutAnOpenGLLibraryTheLineNamesBothAndTheirPackages) {
    fs::create_directory(folder_ / "broken");
    for (const char* name : {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so", "libEGL.so.1"})
        write_text(folder_ / "broken" / name, "");
    const Words broken{"LD_LIBRARY_PATH=" + (folder_ / "broken").string()};
    for (const Words& words : {Words{"run", "scene.toml", "-o", "out", "-q"},
                               Words{"still", "scene.toml", "-o", "out.png", "-q"}}) {
        const Ended ended = fumon(words, folder_.path(), broken);
        expect_one_line(ended, 3, "no OpenGL 3.3 without a display: OSMesa: ");
        for (const char* what : {"libOSMesa.so.8", "package libosmesa6", "EGL: ", "libEGL.so.1",
                                 "packages libegl1 and libgl1-mesa-dri"})
            EXPECT_NE(ended.errors.find(what), std::string::npos) << ended.errors;
    }
    EXPECT_FALSE(fs::exists(folder_ / "out"));
    EXPECT_FALSE(fs::exists(folder_ / "out.png"));
    const Ended without_pictures = fumon({"run", "scene.toml", "-o", "out", "-q", "--set",
                                          "output.frames=false", "--set", "output.movie=false"},
                                         folder_.path(), broken);
    EXPECT_EQ(without_pictures.status, 0) << without_pictures.errors;
}

TEST_F(FaultTest, WhereMemoryEndsADriversCrashIsOneLineToo) {
#ifdef FUMON_SANITIZED
    GTEST_SKIP() << "sanitizers take more address space than any limit that drivers meet";
#endif
    int failed = 0;
    for (const char* kibibytes : {"340000", "360000", "380000", "410000"}) {
        write_text(folder_ / "still.png", "an earlier picture");
        const Ended ended =
            shell(std::string("ulimit -v ") + kibibytes +
                  "; timeout -k 5 60 \"$FUMON\" still scene.toml -o still.png -q --force --step 0");
        if (ended.status == 0) continue;
        ++failed;
        EXPECT_EQ(ended.status, 3) << kibibytes << ended.errors;
        const std::string last =
            ended.errors.substr(ended.errors.rfind('\n', ended.errors.size() - 2) + 1);
        EXPECT_GT(last.size(), 20U) << "a driver may say something before: " << ended.errors;
        EXPECT_EQ(read_text(folder_ / "still.png"), "an earlier picture");
        EXPECT_FALSE(fs::exists(folder_ / "still.png.part"));
    }
    EXPECT_GT(failed, 0) << "the limits are too high to try anything";
}

}  // namespace
}  // namespace fumon::test
