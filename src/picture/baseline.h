#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "keys/keys.h"
#include "picture/baseline_records.h"
#include "picture/compare.h"
#include "picture/named_environment.h"
#include "picture/pixels/ignore_rules.h"

namespace fumon {

/// One picture under test: of a scene, with settings, at a step or time.
struct BaselineCase {
    std::string name;
    std::string place;                      ///< "file:line:column"
    std::string scene;                      ///< relative to the baseline file
    std::vector<std::string> settings;      ///< "key.path=VALUE"
    std::int64_t step = -1;                 ///< negative: the time, else the run's last step
    double time = -1.0;                     ///< in the model's unit; negative: not by time
    bool figure = false;                    ///< the scene's figure, not a frame
    bool picture = false;                   ///< keep the expected picture beside the baseline
    std::vector<std::string> environments;  ///< that may have pictures of their own; the first that
                                            ///< is here counts
    double thumbnail_difference = same_to_the_eye_limits.thumbnail;  ///< that passes, grey levels
    double tile_ssim = same_to_the_eye_limits.tile_ssim;             ///< that passes
    std::string fault;  ///< why nothing can come of it, located; of WrongCases::kept alone

    IgnoreRules ignore;  ///< of which `ignore` itself is read by read_ignore()

    /// Lists its keys under a prefix, bound to it.
    void list_keys(const std::string& prefix, KeyTable& table);
};

/// A baseline: TOML that people write, `[cases]` and what holds for all of them, and its lock
/// beside it, which `fumon verify --update` writes: what is recorded of each case.
struct Baseline {
    std::filesystem::path file;
    std::string head;  ///< what people wrote, as it stands
    std::vector<BaselineCase> cases;
    std::vector<NamedEnvironment> environments;
    BaselineRecords records;  ///< of these cases, by record_name()
    BaselineRecords orphans;  ///< of which there is no case, or no such environment of the case
    bool unlocked = false;    ///< the records stand in the file itself, as before version 0.2

    /// Where the records are kept: "sand.toml" → "sand.lock".
    [[nodiscard]] std::filesystem::path lock() const;

    /// Where the expected picture of a record is kept: "sand.toml" → "sand/NAME.png".
    [[nodiscard]] std::filesystem::path picture_of(const std::string& record) const;
    [[nodiscard]] std::filesystem::path picture_of(const BaselineCase& one) const;

    /// The first of a case's environments that this one is; nullptr where none is.
    [[nodiscard]] const NamedEnvironment* environment_of(const BaselineCase& one,
                                                         const RenderingEnvironment& here) const;
};

/// What becomes of a case that is wrong while its baseline can be read.
enum class WrongCases {
    refused,  ///< the whole baseline is wrong
    kept,     ///< it has a fault; so have all cases where the lock is wrong
};

/// A baseline with its lock. Throws InputError "file:line:column: what is wrong; what would be
/// right" for the first fault of either.
Baseline read_baseline(const std::filesystem::path& file, WrongCases wrong = WrongCases::refused);

}  // namespace fumon
