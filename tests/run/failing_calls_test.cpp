#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "files/checkpoint.h"
#include "files/netcdf/netcdf_input.h"
#include "picture/movie.h"
#include "picture/png.h"
#include "support/disturbed.h"
#include "support/program.h"
#include "support/same_run.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

std::string scene_with(const std::string& output) {
    return "title = \"small\"\nseed = 5\n[model]\nname = \"sandpile\"\ngrains_per_step = 20\n"
           "[grid]\nnx = 12\nny = 10\n[run]\nsteps = 24\n[image]\nwidth = 32\nheight = 24\n"
           "[frames]\nevery = 8\n[output]\navalanches = true\nmeasure_every = 2\n"
           "fields_every = 6\nbed_every = 8\n" +
           output;
}

constexpr const char* no_pictures = "frames = false\nmovie = false\n";

constexpr const char* figure_scene =
    "[model]\nname = \"sandpile\"\n[grid]\nnx = 12\nny = 10\n[run]\nsteps = 20\n"
    "[figure]\nwidth = \"single\"\ndots_per_inch = 60\n[[figure.panel]]\n[[figure.panel.curve]]\n"
    "x = \"step\"\ny = \"mean_height\"\n";

constexpr const char* baseline = "scene = \"scene.toml\"\nstep = 10\n[cases]\nmap = {}\n";

struct Job {
    const char* name;
    std::string scene;
    Words words;
    int samples = 10;      ///< numbers of calls that are tried, for each kind of fault
    bool resumes = false;  ///< goes on with a run that was broken off
};

void PrintTo(const Job& job, std::ostream* out) {
    *out << job.name;
}

const Words run_words{"run", "scene.toml", "-o", "out", "-q"};
const Words checkpointed{"run", "scene.toml", "-o", "out", "-q", "--checkpoint-every", "0.00001"};
const Words resume_words{"run", "--resume", "out", "-q", "--checkpoint-every", "0.00001"};

bool is_run(const Job& job) {
    return job.words.front() == "run";
}

/// What a failing command may leave must be whole under its final name.
void expect_whole(const fs::path& file, const fs::path& undisturbed) {
    SCOPED_TRACE(file.string());
    const std::string name = file.filename().string();
    const std::string bytes = read_text(file);
    if (name == "run.json" || name == "sweep.json") {
        EXPECT_TRUE(nlohmann::json::accept(bytes));
    } else if (name == "checkpoint.fumon") {
        EXPECT_NO_THROW(open_checkpoint(file));
    } else if (name == "movie.mp4") {
        EXPECT_FALSE(read_movie_texts(file).empty());
    } else if (name.find("fields.nc") != std::string::npos) {
        const NetcdfLock lock;
        EXPECT_NO_THROW(NetcdfInput{file});
    } else if (file.extension() == ".csv" && name != "runs.csv" && name != "sweep.csv") {
        EXPECT_TRUE(read_text(undisturbed).starts_with(bytes) && bytes.ends_with("\n"));
    } else if (file.extension() == ".png" && !fs::exists(undisturbed)) {
        EXPECT_NO_THROW(read_png(file));
    } else if (file.extension() == ".png" || file.extension() == ".asc") {
        EXPECT_TRUE(bytes == read_text(undisturbed));
    }
}

/// Whether a file holds times that differ between two runs.
bool has_timings(const fs::path& file) {
    return file.extension() == ".json" || file.filename() == "runs.csv";
}

void expect_same_files(const fs::path& one, const fs::path& other) {
    EXPECT_EQ(files_of_run(one), files_of_run(other));
    for (const std::string& name : files_of_run(one)) {
        if (has_timings(name)) continue;
        EXPECT_TRUE(read_text(one / name) == read_text(other / name)) << name;
    }
}

class FailingCalls : public ::testing::TestWithParam<Job> {
  protected:
    void SetUp() override {
#ifdef FUMON_SANITIZED
        GTEST_SKIP() << "sanitizers want to be the first library";
#endif
        fs::create_directory(ready_);
        write_text(ready_ / "scene.toml", GetParam().scene);
        write_text(ready_ / "b.toml", baseline);
        fs::copy(ready_, whole_, fs::copy_options::recursive);
        const Words undisturbed = GetParam().resumes ? run_words : GetParam().words;
        const Ended ended = fumon(undisturbed, whole_);
        ASSERT_TRUE(ended.status == 0 || GetParam().words.front() == "verify") << ended.errors;
        if (GetParam().resumes) break_off();
    }

    /// Leaves in ready_ a run that its disk left in the lurch, with a checkpoint.
    void break_off() {
        const std::int64_t calls = counted(checkpointed);
        for (std::int64_t call = calls * 3 / 4; call > 0; call -= 3) {
            fresh();
            disturbed_fumon(checkpointed, tried_, {call, EIO, true, {}});
            if (!fs::exists(tried_ / "out/checkpoint.fumon")) continue;
            fs::remove_all(ready_);
            fs::copy(tried_, ready_, fs::copy_options::recursive);
            return;
        }
        FAIL() << "no run left a checkpoint";
    }

    void fresh() const {
        fs::remove_all(tried_);
        fs::copy(ready_, tried_, fs::copy_options::recursive);
    }

    [[nodiscard]] std::int64_t counted(const Words& words) const {
        fresh();
        return disturbed_fumon(words, tried_, {}).report.calls;
    }

    void expect_one_line(const Ended& ended) const {
        std::string errors = ended.errors;
        for (std::size_t end = 0;
             (end = errors.find("; the run continues\n")) != std::string::npos;)
            errors.erase(errors.rfind('\n', end) + 1, errors.find('\n', end) + 1);
        const auto lines = std::count(errors.begin(), errors.end(), '\n');
        EXPECT_GE(lines, 1);
        // Others have a line for each run.
        EXPECT_LE(lines, is_run(GetParam()) ? 1 : 4) << ended.errors;
    }

    /// Whether it refuses a file that could not be read, by name.
    static bool refuses(const Disturbed& done) {
        const std::string what = done.report.what;
        const bool reads =
            what.starts_with("read ") || what.starts_with("open ") || what.starts_with("close ");
        const std::string said = done.ended.errors + done.ended.output;  // verify's cases
        const bool names = said.find("fields.nc") != std::string::npos ||
                           said.find(fs::path(what).filename().string()) != std::string::npos;
        return done.ended.status == 2 && reads && names;
    }

    /// What a user would do now.
    [[nodiscard]] Ended again() const {
        if (!is_run(GetParam())) {
            const Ended ended = fumon(GetParam().words, tried_);
            // What could not even be taken away is in the way like others' files.
            if (ended.errors.find(".part: already exists") == std::string::npos) return ended;
            Words forced = GetParam().words;
            forced.emplace_back("--force");
            return fumon(forced, tried_);
        }
        if (fs::exists(tried_ / "out/checkpoint.fumon"))
            return fumon({"run", "--resume", "out", "-q"}, tried_);
        Words from_the_start = run_words;
        from_the_start.emplace_back("--force");
        return fumon(from_the_start, tried_);
    }

    void try_with(const Disturbance& disturbance) {
        fresh();
        const Disturbed done = disturbed_fumon(GetParam().words, tried_, disturbance);
        SCOPED_TRACE(std::string(GetParam().name) + ": " + done.report.what + " (" +
                     std::to_string(disturbance.call) + ") fails with " +
                     std::strerror(disturbance.error) + (disturbance.lasting ? ", for good" : "") +
                     "; status " + std::to_string(done.ended.status) + ": " + done.ended.errors);
        const bool verifies = GetParam().words.front() == "verify";
        const bool told = verifies && done.ended.errors.empty();  // as results of cases
        const bool ended_well = done.ended.status == 0 || (told && done.ended.status == 1);
        if (!ended_well) {
            EXPECT_TRUE(done.ended.status == 3 || refuses(done));
            if (!told) expect_one_line(done.ended);
        }
        const fs::path out = tried_ / "out";
        if (fs::exists(out)) {
            const bool goes_on = fs::exists(out / "checkpoint.fumon");
            for (const std::string& name : files_of_run(out)) {
                const bool temporary =
                    name.find(".part") != std::string::npos || name.starts_with("fields.nc.");
                if (temporary) {
                    EXPECT_TRUE(goes_on || disturbance.lasting) << name;
                } else {
                    expect_whole(out / name, whole_ / "out" / name);
                }
            }
        }
        if (!ended_well || fs::exists(out / "checkpoint.fumon")) {
            const Ended ended = again();
            EXPECT_EQ(ended.status == 0 || verifies, true) << ended.errors;
        }
        if (is_run(GetParam())) {
            expect_same_run(whole_ / "out", out);
        } else {
            expect_same_files(whole_ / "out", out);
        }
        ++tried_count_;
    }

    ScratchFolder folder_;
    fs::path ready_ = folder_ / "ready";  ///< what every try begins with
    fs::path whole_ = folder_ / "whole";  ///< what an undisturbed command leaves
    fs::path tried_ = folder_ / "tried";
    int tried_count_ = 0;
};

TEST_P(FailingCalls, LeaveWholeFilesAndWorkThatGoesOn) {
    const std::int64_t calls = counted(GetParam().words);
    ASSERT_GT(calls, 10);
    std::int64_t kind = 0;
    for (const bool lasting : {false, true}) {
        for (const int error : {EIO, ENOSPC}) {
            const std::int64_t stride =
                tries_all_failures() ? 1 : std::max<std::int64_t>(calls / GetParam().samples, 1);
            for (std::int64_t call = 1 + kind * stride / 4; call <= calls; call += stride) {
                try_with({call, error, lasting, {}});
                if (HasFailure()) return;
            }
            ++kind;
        }
    }
    RecordProperty("calls", std::to_string(calls));
    RecordProperty("tried", tried_count_);
    if (tries_all_failures())
        std::printf("%s: %lld operations, %d runs\n", GetParam().name,
                    static_cast<long long>(calls), tried_count_);
}

INSTANTIATE_TEST_SUITE_P(
    Every, FailingCalls,
    ::testing::Values(Job{"Run", scene_with(""), run_words, 1},
                      Job{"Numbers", scene_with(no_pictures), run_words, 4},
                      Job{"Checkpoints", scene_with(no_pictures), checkpointed, 4},
                      Job{"MovieOnly", scene_with("frames = false\n"), checkpointed, 1},
                      Job{"Resume", scene_with(no_pictures), resume_words, 4, true},
                      Job{"ResumePictures", scene_with(""), resume_words, 1, true},
                      Job{"Sweep",
                          scene_with(no_pictures),
                          {"sweep", "scene.toml", "-o", "out", "-q", "--seeds", "2", "--threads",
                           "1"},
                          3},
                      Job{"Figure", figure_scene, {"figure", "scene.toml", "-o", "out", "-q"}, 2},
                      Job{"Verify", scene_with(no_pictures), {"verify", "b.toml", "-o", "out"}, 1}),
    [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace fumon::test
