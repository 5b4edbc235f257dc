#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "base/error.h"
#include "run/resume.h"
#include "run/run_folder.h"
#include "support/program.h"
#include "support/same_run.h"
#include "support/temporary_folder.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;

/// A pile that writes every kind of output, and how it is stopped.
struct Stopped {
    bool frames = true;
    bool movie = true;
    int signal = SIGINT;
};

void PrintTo(const Stopped& stopped, std::ostream* out) {
    *out << (stopped.frames ? "Frames" : "") << (stopped.movie ? "Movie" : "")
         << (stopped.signal == SIGKILL ? "Killed" : "Interrupted");
}

std::string scene_of(const Stopped& stopped) {
    const auto word = [](bool yes) { return std::string(yes ? "true" : "false"); };
    return "seed = 3\n[model]\nname = \"sandpile\"\ngrains_per_step = 30\n[grid]\nnx = 20\nny = "
           "20\n[run]\nsteps = 2500\n[frames]\nevery = 500\n[image]\nwidth = 64\nheight = 48\n"
           "[output]\nframes = " +
           word(stopped.frames) + "\nmovie = " + word(stopped.movie) +
           "\navalanches = true\nbed_every = 500\nfields_every = 500\nmeasure_every = 20\n";
}

struct Damage {
    const char* name;
    std::function<std::string(const std::string&)> done_to;  ///< none: the file is deleted
};

const std::vector<Damage>& damages() {
    static const std::vector<Damage> all{
        {"a flipped bit",
         [](std::string bytes) {
             bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
             return bytes;
         }},
        {"cut", [](const std::string& bytes) { return bytes.substr(0, bytes.size() / 3); }},
        {"empty", [](const std::string&) { return std::string(); }},
        {"foreign", [](const std::string& bytes) { return std::string(bytes.size(), '7'); }},
        {"longer", [](const std::string& bytes) { return bytes + "7,7\n"; }},
        {"gone", nullptr},
    };
    return all;
}

/// All files with their bytes.
using Content = std::map<std::string, std::string>;

Content content_of(const fs::path& folder) {
    Content content;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file())
            content[fs::relative(entry.path(), folder).string()] = read_text(entry.path());
    }
    return content;
}

void wait_until(const std::function<bool()>& condition) {
    const auto start = std::chrono::steady_clock::now();
    while (!condition()) {
        ASSERT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(60));
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

class DamagedOutputs : public ::testing::TestWithParam<Stopped> {
  protected:
    void SetUp() override {
        write_text(folder_ / "scene.toml", scene_of(GetParam()));
        ASSERT_EQ(fumon({"run", "scene.toml", "-o", "whole", "-q"}, folder_.path()).status, 0);
        Program program({"run", "scene.toml", "-o", "stopped", "-q", "--checkpoint-every", "1e-6"},
                        folder_.path());
        const fs::path stopped = folder_ / "stopped";
        wait_until([&] { return fs::exists(stopped / "beds/bed_00000500.asc"); });
        program.send(SIGINT);
        ASSERT_EQ(program.wait().status, 128 + SIGINT) << "the run was too short";
        if (GetParam().signal != SIGKILL) return;
        Program killed({"run", "--resume", "stopped", "-q"}, folder_.path());
        wait_until([&] { return fs::exists(stopped / "measurements.csv.part"); });
        killed.send(SIGKILL);
        ASSERT_EQ(killed.wait().status, 128 + SIGKILL) << "the run was too short";
    }

    /// A copy of the stopped run.
    void stopped_again() const {
        fs::remove_all(folder_ / "out");
        fs::copy(folder_ / "stopped", folder_ / "out", fs::copy_options::recursive);
    }

    /// The files of the stopped run; of frames and beds those of the first two.
    [[nodiscard]] std::vector<std::string> files() const {
        std::vector<std::string> names;
        std::map<std::string, int> of_folder;
        for (const auto& [name, bytes] : content_of(folder_ / "stopped")) {
            const std::string folder = fs::path(name).parent_path().string();
            if (folder.empty() || ++of_folder[folder] <= 2) names.push_back(name);
        }
        return names;
    }

    /// What a resumed run says of the folder; it changes nothing there.
    [[nodiscard]] std::string refusal() const {
        const Content before = content_of(folder_ / "out");
        const std::string what = message_of<InputError>([&] {
            RunFolder folder(folder_ / "out", true);
            folder.enter();
            resume_run(folder, "", {});
        });
        EXPECT_TRUE(before == content_of(folder_ / "out")) << "nothing is changed";
        return what;
    }

    void expect_resumed() const {
        const Ended ended = fumon({"run", "--resume", "out", "-q"}, folder_.path());
        EXPECT_EQ(ended.status, 0) << ended.errors;
        expect_same_run(folder_ / "whole", folder_ / "out");
    }

    ScratchFolder folder_;
};

/// Whether a resumed run writes the file anew, or cuts it where it is too long.
bool is_made_again(const std::string& name, const Damage& damage) {
    const std::string damaged = damage.name;
    if (name.starts_with("movie.mp4")) return true;
    if (name == "run.json") return damaged != "gone";
    const bool grows = name.starts_with("measurements.") || name.starts_with("avalanches.") ||
                       name.starts_with("fields.") || name.starts_with("frames.");
    return grows && damaged == "longer";
}

void do_damage(const fs::path& file, const Damage& damage, const std::string& bytes) {
    if (damage.done_to) {
        write_text(file, damage.done_to(bytes));
    } else {
        fs::remove(file);
    }
}

TEST_P(DamagedOutputs, AreMadeAgainOrRefusedByName) {
    stopped_again();
    EXPECT_EQ(refusal(), "");
    std::set<std::string> kinds;
    std::map<std::string, std::vector<const Damage*>> accepted;
    for (const std::string& name : files()) {
        const fs::path file = folder_ / "out" / name;
        const std::string bytes = read_text(file);
        const bool is_begun_again = name == "fields.nc.part";
        for (const Damage& damage : damages()) {
            SCOPED_TRACE(name + ", " + damage.name);
            do_damage(file, damage, bytes);
            const std::string what = refusal();
            write_text(file, bytes);
            kinds.insert(name.substr(0, name.find_first_of("/.")));
            const std::string told = name == "run.json" ? "out holds no run" : file.stem().string();
            if (what.empty()) {
                accepted[name].push_back(&damage);
                const bool idle_byte = name.starts_with("fields.") && &damage == &damages().front();
                EXPECT_TRUE(idle_byte || is_begun_again || is_made_again(name, damage));
            } else {
                EXPECT_FALSE(is_made_again(name, damage)) << what;
                EXPECT_NE(what.find(told), std::string::npos) << what;
            }
        }
    }
    const bool pictures = GetParam().frames || GetParam().movie;
    EXPECT_EQ(kinds.contains("frames"), pictures) << "the list or the files";
    EXPECT_EQ(kinds.contains("movie_frames"), GetParam().movie && !GetParam().frames);
    for (const char* kind : {"avalanches", "beds", "checkpoint", "fields", "measurements", "run"})
        EXPECT_TRUE(kinds.contains(kind)) << kind;

    for (const char* bed : {"beds/bed_00000000.asc", "beds/bed_00000500.asc"})
        fs::remove(folder_ / "out" / bed);
    const std::string several = refusal();
    EXPECT_NE(
        several.find("bed_00000000.asc: does not exist (and 1 more file differs); restore it"),
        std::string::npos)
        << several;

    for (const bool first : {true, false}) {
        stopped_again();
        for (const auto& [name, by] : accepted) {
            const fs::path file = folder_ / "out" / name;
            do_damage(file, first ? *by.front() : *by.back(), read_text(file));
        }
        write_text(folder_ / "out/beds/bed_00002500.asc.part", "of a write that was broken off");
        expect_resumed();
    }
}

INSTANTIATE_TEST_SUITE_P(Every, DamagedOutputs,
                         ::testing::Values(Stopped{true, true}, Stopped{true, false},
                                           Stopped{false, true}, Stopped{false, false},
                                           Stopped{true, true, SIGKILL}),
                         ::testing::PrintToStringParamName());

}  // namespace
}  // namespace fumon::test
