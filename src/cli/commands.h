#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "picture/compare.h"
#include "run/terminal/work_options.h"

namespace fumon {

struct RunOptions {
    std::string scene;
    std::string folder;
    bool force = false;
    std::string resume;              ///< the folder of a run to go on with; empty: a new run
    double checkpoint_every = 10.0;  ///< minutes; 0: no checkpoints
    WorkOptions work;
};

struct SweepOptions {
    std::string scene;
    std::vector<std::string> over;  ///< "key=v1,v2" or "key=low:high:count"
    std::string seeds;              ///< "10" or "1:10"
    std::string folder;
    bool force = false;
    WorkOptions work;
};

struct FigureOptions {
    std::vector<std::string> scenes;
    std::string folder;
    std::string runs;  ///< the folder of finished runs; empty: "runs" in the figures' folder
    WorkOptions work;
};

struct StillOptions {
    std::string input;   ///< a scene (.toml) or a terrain file
    std::string output;  ///< a PNG
    std::optional<std::int64_t> step;
    std::optional<double> time;
    std::string heights;  ///< "low:high", metres of black and white of a PNG terrain
    WorkOptions work;
};

struct HopLawOptions {
    std::string scene;   ///< of the model airflow
    std::string output;  ///< the sand scene to write
    std::string form = "exponential";
    std::int64_t hops = 1;  ///< in succession
    std::string into;       ///< the sand scene that gets the law; empty: Terada's ripples
    std::string flights;    ///< a CSV file of all flights; empty: none
    WorkOptions work;
};

struct AgainOptions {
    std::string picture;
    std::string output;  ///< empty: NAME-again.png (or .mp4, .pdf, .svg) in the working folder
    std::string runs;    ///< of a figure: the folder of finished runs; empty: "runs" beside it
    WorkOptions work;
};

struct MeasureOptions {
    std::string bed;
    std::string heights;      ///< "low:high", metres of black and white of a PNG terrain
    std::string as;           ///< "bed", "profile", "pile"; empty: by the bed's rows
    bool open_edges = false;  ///< the bed ends at its edges
    std::vector<int> drop;    ///< x and y of a pile's drop site; empty: its middle
    std::string earlier;      ///< a bed of the same run, for celerity
    std::int64_t steps_between = 0;
    std::string window;  ///< "low:high", cells: where avalanche sizes are fitted
    bool as_json = false;
    std::vector<std::string> settings;
};

struct FingerprintOptions {
    std::vector<std::string> images;
    bool as_json = false;
};

struct CompareOptions {
    std::string first;
    std::string second;
    Likeness level = Likeness::same_to_the_eye;  ///< that passes
    std::string difference;                      ///< a PNG to write; empty: none
};

struct VerifyOptions {
    std::vector<std::string> baselines;
    std::string folder = "verify-out";  ///< made only when something does not pass
    std::string junit;                  ///< a file of JUnit XML; empty: none
    bool update = false;
    WorkOptions work;

    [[nodiscard]] bool quietly() const { return work.verbosity == Verbosity::quiet; }
};

// Each returns the exit status, and throws InputError (2) or Error (1).

int run_command(const RunOptions& options);
int sweep_command(const SweepOptions& options);
int figure_command(const FigureOptions& options);
int still_command(const StillOptions& options);
int hop_law_command(const HopLawOptions& options);
int again_command(const AgainOptions& options);
int measure_command(const MeasureOptions& options);
int measure_avalanches(const MeasureOptions& options);  ///< of avalanches.csv
int fingerprint_command(const FingerprintOptions& options);
int compare_command(const CompareOptions& options);
int verify_command(const VerifyOptions& options);
int check_command(const std::vector<std::string>& scenes, const std::vector<std::string>& settings);

}  // namespace fumon
