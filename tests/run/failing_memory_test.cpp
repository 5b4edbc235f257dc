#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "support/disturbed.h"
#include "support/preload/memory_report.h"
#include "support/program.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

/// A command that reads a file, and the file.
struct Reader {
    const char* name;
    Words words;
    const char* file;
};

void PrintTo(const Reader& reader, std::ostream* out) {
    *out << reader.name;
}

class FailingMemory : public ::testing::TestWithParam<Reader> {
  protected:
    void SetUp() override {
#ifdef FUMON_SANITIZED
        GTEST_SKIP() << "sanitizers have a memory of their own";
#endif
        // As where a limit may be met: C libraries that crash then are told of in one line, too.
        getrlimit(RLIMIT_AS, &previous_);
        const rlimit limit{rlim_t{1} << 40, previous_.rlim_max};
        setrlimit(RLIMIT_AS, &limit);
        write_text(folder_ / "scene.toml",
                   "[model]\nname = \"sandpile\"\n[grid]\nnx = 12\nny = 10\n[run]\nsteps = 20\n"
                   "[image]\nwidth = 32\nheight = 24\n[output]\nframes = false\nmovie = false\n"
                   "fields_every = 10\nbed_every = 5\nmeasure_every = 1\n");
        write_text(folder_ / "bed.asc", "ncols 3\nnrows 2\ncellsize 1\n1 2 3\n4 5 6\n");
        ASSERT_EQ(run({"run", "scene.toml", "-o", "out", "-q"}).status, 0);
        leave_checkpoint();
        ASSERT_EQ(run({"still", "bed.asc", "-o", "bed.png", "-q", "--set", "image.width=32",
                       "--set", "image.height=24"})
                      .status,
                  0);
    }

    /// Leaves in "kept" a run that its disk left in the lurch.
    void leave_checkpoint() const {
        for (std::int64_t call = 150; call > 0; call -= 4) {
            fs::remove_all(folder_ / "kept");
            disturbed_fumon(
                {"run", "scene.toml", "-o", "kept", "-q", "--checkpoint-every", "0.00001"},
                folder_.path(), {call, EIO, true, {}});
            if (fs::exists(folder_ / "kept/checkpoint.fumon")) return;
        }
        FAIL() << "no run left a checkpoint";
    }

    void TearDown() override {
        setrlimit(RLIMIT_AS, &previous_);
    }

    [[nodiscard]] Ended run(const Words& words) const {
        return fumon(words, folder_.path());
    }

    [[nodiscard]] MemoryReport report() const {
        MemoryReport report;
        const std::string bytes = read_text(folder_ / "report");
        if (bytes.size() == sizeof report) std::memcpy(&report, bytes.data(), sizeof report);
        return report;
    }

    [[nodiscard]] Ended run_without(std::int64_t request) const {
        fs::remove(folder_ / "report");
        fs::remove_all(folder_ / "left");
        fs::copy(folder_ / "kept", folder_ / "left", fs::copy_options::recursive);
        return fumon(GetParam().words, folder_.path(),
                     {"LD_PRELOAD=" FUMON_FAILING_MEMORY,
                      std::string("FUMON_MEMORY_AFTER=") + GetParam().file,
                      "FUMON_MEMORY_FAIL=" + std::to_string(request),
                      "FUMON_MEMORY_REPORT=" + (folder_ / "report").string()});
    }

    ScratchFolder folder_;
    rlimit previous_{RLIM_INFINITY, RLIM_INFINITY};
};

constexpr std::array<std::string_view, 8> library_lines{
    "HDF5-DIAG: ", "  ",          "bytebuffer failure", "malloc(): ",
    "free(): ",    "realloc(): ", "corrupted ",         "double free"};

/// But for the note that a file has several records, and for what libraries print themselves: HDF5
/// where it has no memory to begin, before it can be silenced, NetCDF where none is left for an
/// address, and the C library where HDF5, finding none later, has spoilt its heap.
std::int64_t count_lines(const std::string& errors) {
    std::int64_t count = 0;
    std::istringstream lines(errors);
    for (std::string line; std::getline(lines, line);) {
        const bool is_of_library =
            std::ranges::any_of(library_lines, [&](auto begin) { return line.starts_with(begin); });
        if (!is_of_library && !line.ends_with("of bed_height is read")) ++count;
    }
    return count;
}

TEST_P(FailingMemory, IsOneLine) {
    ASSERT_EQ(run_without(0).status, 0);
    const std::int64_t requests = report().requests;
    ASSERT_GT(requests, 10);
    const std::int64_t samples = tries_all_failures() ? requests : 12;
    int told = 0;
    for (std::int64_t k = 0; k < samples; ++k) {
        const std::int64_t request =
            1 + k * (requests - 1) / std::max<std::int64_t>(samples - 1, 1);
        const Ended ended = run_without(request);
        SCOPED_TRACE(std::string(GetParam().name) + ": request " + std::to_string(request) +
                     " of " + std::to_string(requests) + "; status " +
                     std::to_string(ended.status) + ": " + ended.errors);
        if (ended.status == 0) continue;
        ++told;
        // HDF5 does not tell want of memory from damage or a file that may not be read: such a file
        // is refused by name.
        const bool is_refused = ended.errors.find("fields.nc") != std::string::npos;
        const bool is_palette = ended.errors.find(".txt: cannot be read\n") != std::string::npos;
        EXPECT_TRUE(ended.status == 3 || is_refused);
        EXPECT_EQ(count_lines(ended.errors), 1);
        EXPECT_TRUE(is_refused || is_palette || ended.errors.find("memory") != std::string::npos);
        if (HasFailure() && !tries_all_failures()) return;
    }
    EXPECT_GT(told, 0);
    if (tries_all_failures())
        std::printf("%s: %lld requests, %d told\n", GetParam().name,
                    static_cast<long long>(requests), told);
}

INSTANTIATE_TEST_SUITE_P(
    Every, FailingMemory,
    ::testing::Values(
        Reader{"Scene", {"check", "scene.toml"}, "scene.toml"},
        Reader{"EsriAscii", {"measure", "bed.asc"}, "bed.asc"},
        Reader{"Netcdf", {"measure", "out/fields.nc"}, "out/fields.nc"},
        Reader{"Picture", {"compare", "bed.png", "bed.png", "--ignore", "0,0,1,1"}, "bed.png"},
        Reader{"Checkpoint", {"run", "--resume", "left", "-q"}, "checkpoint.fumon"}),
    [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace fumon::test
