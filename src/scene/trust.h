#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "scene/faults.h"
#include "scene/scene.h"

namespace fumon {

/// The most that a scene may ask for that the user did not name: one that stands in a picture's
/// metadata, or that a baseline names. All shipped scenes stay far below.
struct TrustLimits {
    std::int64_t cells = 1LL << 22;    ///< of the grid, and of the air's equations
    std::int64_t steps = 10'000'000;   ///< of a run
    double cell_steps = 1e12;          ///< hours of work
    double grains = 1e9;               ///< dropped on a pile
    std::int64_t samples = 1LL << 27;  ///< of a picture: its pixels, times supersampling²
    std::int64_t frames = 100'000;     ///< of a movie
};
inline constexpr TrustLimits trust_limits{};

/// Of a scene that is not trusted: adds what exceeds the limits to `faults`, located at the key,
/// and says how to lift them. What a terrain file brings is not known yet.
void check_limits(const Scene& scene, Faults& faults);

/// Throws InputError where a scene that is not trusted has a bed of too many cells, or takes too
/// long to a step.
void check_limits(const Scene& scene, std::int64_t cells, std::int64_t steps);

/// Throws InputError where others named the file of a key and only --trust opens it
/// (why_trust_is_needed). Of a file that a picture's metadata lists its content may count, of any
/// other its name alone.
void check_trust(const Scene& scene, const std::string& key, const std::filesystem::path& file);

/// Checks a file that a key other than bed.file names as `written`. Throws InputError where it does
/// not exist, and as check_trust(); in a scene of others, whose messages tell of no file whether it
/// is there, where it is none of the files that a picture's metadata lists by their SHA-256.
void check_named_file(const Scene& scene, const std::string& key, const std::string& written,
                      const std::filesystem::path& file);

/// Whether a file's content may be told: the user named it or trusts the scene.
bool is_own_file(const Scene& scene, const std::string& key);

/// Whether messages may tell what is in a scene's terrain file: not where others named it.
bool may_report_bed(const Scene& scene);

}  // namespace fumon
