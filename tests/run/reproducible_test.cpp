#include <elf.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <set>
#include <sstream>

#include "files/hash.h"
#include "support/program.h"
#include "vectors/target.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;

/// A short run, and the SHA-256 of what it comes to: a record of state_hashes.txt.
struct RecordedRun {
    std::string name;
    std::string model;
    std::vector<std::string> settings;
    std::string state;
    std::string measurements;
};

std::vector<RecordedRun> read_cases() {
    std::vector<RecordedRun> cases;
    std::ifstream file(FUMON_TEST_FOLDER "/run/state_hashes.txt");
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        std::string first;
        if (!(words >> first) || first.starts_with("#")) continue;
        if (first == "state") {
            words >> cases.back().state;
        } else if (first == "measurements") {
            words >> cases.back().measurements;
        } else {
            cases.push_back({first, {}, {}, {}, {}});
            words >> cases.back().model;
            for (std::string setting; words >> setting;) cases.back().settings.push_back(setting);
        }
    }
    return cases;
}

void PrintTo(const RecordedRun& run, std::ostream* out) {
    *out << run.name;
}

/// Takes from the system's library what needs AVX2, FMA or AVX-512.
const std::vector<std::string> lesser_library = {
    "GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX512F,-AVX512VL,-AVX512DQ,-AVX512BW,-AVX512CD,-AVX2,-FMA,"
    "-FMA4,-AVX,-AVX2_Usable,-FMA_Usable,-AVX_Usable"};

class Reproducible : public ::testing::TestWithParam<RecordedRun> {
  protected:
    /// Runs the case and compares it with its record.
    void expect_as_recorded(int threads, const std::vector<std::string>& environment = {},
                            const std::string& program = FUMON_PROGRAM) {
        const RecordedRun& run = GetParam();
        const ScratchFolder folder;
        write_text(folder / "scene.toml", "seed = 11\n[model]\nname = \"" + run.model + "\"\n");
        fs::copy_file(FUMON_SCENES_FOLDER "/../assets/terrain/west_bijou_gully.asc",
                      folder / "gully.asc");
        std::vector<std::string> arguments{"run", "scene.toml", "-o", "out", "--quiet"};
        arguments.insert(arguments.end(), {"--threads", std::to_string(threads)});
        for (const char* setting :
             {"output.frames=false", "output.movie=false", "output.measure_every=10"}) {
            arguments.insert(arguments.end(), {"--set", setting});
        }
        for (const std::string& setting : run.settings)
            arguments.insert(arguments.end(), {"--set", setting});
        const Ended ended = fumon(arguments, folder.path(), environment, program);
        ASSERT_EQ(ended.status, 0) << ended.errors;
        EXPECT_EQ(read_manifest(folder / "out")["state_sha256"], run.state);
        EXPECT_EQ(hex(file_hash(folder / "out/measurements.csv")), run.measurements)
            << read_text(folder / "out/measurements.csv");
    }

    void SetUp() override {
#if !defined(__x86_64__)
        GTEST_SKIP() << "the records hold for x86-64";
#endif
    }
};

TEST_P(Reproducible, WithAnyNumberOfThreads) {
    for (const int threads : {1, 2, 3, 8}) {
        SCOPED_TRACE(threads);
        expect_as_recorded(threads);
    }
}

TEST_P(Reproducible, WithALesserSystemLibrary) {
    expect_as_recorded(2, lesser_library);
}

TEST_P(Reproducible, WithTheLoopsOfLesserProcessors) {
    for (const std::string& target : vectors::targets()) {
        SCOPED_TRACE(target);
        const std::vector<std::string> chosen{"FUMON_VECTOR_TARGET=" + target};
#ifdef FUMON_ON_PLAIN_PROCESSOR
        const bool is_plain = target == "plain" || target == "sse4";
        expect_as_recorded(2, chosen,
                           is_plain           ? FUMON_ON_PLAIN_PROCESSOR
                           : target == "avx2" ? FUMON_ON_AVX2_PROCESSOR
                                              : FUMON_PROGRAM);
#else
        expect_as_recorded(2, chosen);
#endif
    }
}

INSTANTIATE_TEST_SUITE_P(All, Reproducible, ::testing::ValuesIn(read_cases()),
                         [](const auto& chosen) {
                             std::string name = chosen.param.name;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

TEST(ReproducibleSweep, IsTheSameTableOnALesserProcessor) {
    const ScratchFolder folder;
    write_text(folder / "scene.toml", small_scene());
    const auto sweep = [&](const std::string& output, const std::string& threads,
                           const std::vector<std::string>& environment,
                           const std::string& program) {
        const Ended ended = fumon({"sweep", "scene.toml", "-o", output, "--quiet", "--threads",
                                   threads, "--over", "model.creep_rate=0.1,0.2", "--seeds", "2"},
                                  folder.path(), environment, program);
        ASSERT_EQ(ended.status, 0) << ended.errors;
    };
#ifdef FUMON_ON_PLAIN_PROCESSOR
    const std::string lesser = FUMON_ON_PLAIN_PROCESSOR;
#else
    const std::string lesser = FUMON_PROGRAM;
#endif
    sweep("here", "1", {}, FUMON_PROGRAM);
    sweep("there", "4", lesser_library, lesser);
    EXPECT_EQ(read_text(folder / "here/sweep.csv"), read_text(folder / "there/sweep.csv"));
    const auto states = [&](const std::string& output) {
        std::vector<std::string> found;
        std::istringstream rows(read_text(folder / output / "runs.csv"));
        for (std::string row; std::getline(rows, row);) {
            const std::size_t message = row.rfind(',');
            const std::size_t state = row.rfind(',', message - 1) + 1;
            found.push_back(row.substr(state, message - state));
        }
        return found;
    };
    EXPECT_EQ(states("here"), states("there"));
    EXPECT_EQ(states("here").size(), 5U);
    EXPECT_EQ(states("here").back().size(), 64U) << "a SHA-256";
}

/// The names that a program takes from shared libraries.
std::set<std::string> imports_of(const std::string& program) {
    const std::string bytes = read_text(program);
    const auto at = [&]<class Record>(std::size_t offset, Record record) {
        std::memcpy(&record, bytes.substr(offset, sizeof record).data(), sizeof record);
        return record;
    };
    const auto header = at(0, Elf64_Ehdr{});
    const auto section = [&](std::size_t i) {
        return at(header.e_shoff + i * sizeof(Elf64_Shdr), Elf64_Shdr{});
    };
    std::set<std::string> names;
    for (std::size_t i = 0; i < header.e_shnum; ++i) {
        if (section(i).sh_type != SHT_DYNSYM) continue;
        const std::size_t texts = section(section(i).sh_link).sh_offset;
        for (std::size_t offset = 0; offset < section(i).sh_size; offset += sizeof(Elf64_Sym)) {
            const auto symbol = at(section(i).sh_offset + offset, Elf64_Sym{});
            if (symbol.st_shndx == SHN_UNDEF) names.insert(bytes.c_str() + texts + symbol.st_name);
        }
    }
    return names;
}

/// Their bits depend on the processor, so fumon does without them.
TEST(ReproducibleProgram, TakesNoElementaryFunctionFromTheSystem) {
#ifdef FUMON_SANITIZED
    GTEST_SKIP() << "the sanitizers take them";
#endif
    const std::set<std::string> imports = imports_of(FUMON_PROGRAM);
    ASSERT_TRUE(imports.contains("snprintf")) << "imports are found so";
    for (const std::string name :
         {"sin",  "cos",    "sincos", "tan",  "asin", "acos",  "atan",  "atan2",
          "sinh", "cosh",   "tanh",   "exp",  "exp2", "exp10", "expm1", "log",
          "log2", "log10",  "log1p",  "pow",  "cbrt", "hypot", "fma",   "erf",
          "erfc", "lgamma", "tgamma", "cexp", "clog", "cpow",  "csqrt", "cabs"}) {
        EXPECT_FALSE(imports.contains(name)) << name;
        EXPECT_FALSE(imports.contains(name + "f")) << name << "f";
    }
}

}  // namespace
}  // namespace fumon::test
