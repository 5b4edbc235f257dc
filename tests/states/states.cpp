// Makes the runs of tests/run/state_hashes.txt and compares them with their records, without
// anything that draws: for processors and compilers on which only the models are built
// (FUMON_PICTURES=OFF).
//
//     fumon_states RECORDS TERRAIN [THREADS]     tests/run/state_hashes.txt,
//     assets/terrain/west_bijou_gully.asc
//
// Exit status: 0 all records met, 1 some not, 2 wrong usage.

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/worker_pool.h"
#include "files/hash.h"
#include "files/scratch_folder.h"
#include "models/registry.h"
#include "models/shared/state_hash.h"
#include "run/recorder.h"
#include "run/stepper.h"
#include "scene/initial_bed.h"
#include "scene/read.h"
#include "vectors/target.h"

namespace {

namespace fs = std::filesystem;
using namespace fumon;

struct Record {
    std::string name;
    std::string model;
    std::vector<std::string> settings;
    std::string state;
    std::string measurements;
};

constexpr const char* as_recorded = "as recorded";

std::vector<Record> read_records(const char* path) {
    std::vector<Record> records;
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        std::string first;
        if (!(words >> first) || first.starts_with("#")) continue;
        if (first == "state") {
            words >> records.back().state;
        } else if (first == "measurements") {
            words >> records.back().measurements;
        } else {
            records.push_back({first, {}, {}, {}, {}});
            words >> records.back().model;
            for (std::string setting; words >> setting;) records.back().settings.push_back(setting);
        }
    }
    return records;
}

/// Makes a run and tells how it compares with its record. Throws as the parts of a run do.
std::string verdict_of(const Record& record, const fs::path& folder, int threads) {
    std::vector<std::string> settings{"output.frames=false", "output.movie=false",
                                      "output.measure_every=10"};
    settings.insert(settings.end(), record.settings.begin(), record.settings.end());
    const std::string text = "seed = 11\n[model]\nname = \"" + record.model + "\"\n";
    Scene scene = parse_scene(text, "scene.toml", folder, settings);
    const InitialBed initial = make_initial_bed(scene);
    scene.grid.nx = initial.bed.nx();
    scene.grid.ny = initial.bed.ny();
    WorkerPool pool(threads, "fumon-simulate");
    const auto model =
        find_model(scene.model.name)
            ->make(scene.model.parameters,
                   {initial.bed, initial.nodata, initial.scale,
                    static_cast<std::uint64_t>(scene.seed), pool, !scene.bed.file.empty()});
    const fs::path table = folder / (record.name + ".csv");
    const RecordPaths paths{table, folder / "avalanches.csv", folder / "fields.nc"};
    Recorder recorder(scene, model->snapshot(), {paths, "", false});
    Stepper stepper(*model, {&recorder});
    stepper.advance(at_step(scene.run.steps));
    recorder.commit();
    const std::string state = hex(state_hash(*model));
    const std::string measurements = hex(file_hash(table));
    if (state == record.state && measurements == record.measurements) return as_recorded;
    return "DIFFERS: state " + state + ", measurements " + measurements;
}

}  // namespace

int main(int count, char** words) {
    if (count < 3) {
        std::fprintf(stderr, "fumon_states RECORDS TERRAIN [THREADS]\n");
        return 2;
    }
    try {
        vectors::use_target_of_environment();
    } catch (const InputError& refusal) {
        std::fprintf(stderr, "%s\n", refusal.what());
        return 2;
    }
    const ScratchFolder folder;
    fs::copy_file(words[2], folder.path() / "gully.asc");
    const auto records = read_records(words[1]);
    fs::current_path(folder.path());  // where the records' settings look for the terrain
    int met = 0;
    for (const Record& record : records) {
        std::string verdict;
        try {
            verdict = verdict_of(record, folder.path(), count > 3 ? std::atoi(words[3]) : 2);
        } catch (const std::exception& fault) {
            verdict = fault.what();
        }
        met += verdict == as_recorded ? 1 : 0;
        std::printf("%-22s %s\n", record.name.c_str(), verdict.c_str());
        std::fflush(stdout);
    }
    std::printf("%d of %zu met\n", met, records.size());
    return met == static_cast<int>(records.size()) ? 0 : 1;
}
