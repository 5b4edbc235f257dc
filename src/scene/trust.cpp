#include "scene/trust.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "base/number_text.h"
#include "files/terrain/grid_hash.h"
#include "files/terrain/raster_trust.h"
#include "keys/keys.h"
#include "scene/scene_keys.h"
#include "scene/schedule.h"

namespace fumon {

namespace {

constexpr const char* lifted = "; --trust lifts this limit";

/// A whole number of the scene's model; 1 where it has no such key.
std::int64_t factor_of(Scene scene, const char* path) {
    const KeyTable table = scene_keys(scene);
    const Key* key = table.find(path);
    if (key == nullptr) return 1;
    const auto* value = std::get_if<std::int64_t*>(&key->target);
    return value != nullptr ? **value : 1;
}

/// What the memory of a model grows with: air has as many nodes as columns times levels, and an
/// equation between any two columns.
double size_of(const Scene& scene, std::int64_t cells) {
    const std::int64_t levels = factor_of(scene, "model.nz");
    return static_cast<double>(cells) *
           static_cast<double>(levels > 1 ? std::max(levels, cells) : 1);
}

std::string amount(double number) {
    constexpr double exact = 1e15;
    return number < exact ? with_commas(static_cast<std::int64_t>(number))
                          : fmt::format("{:.3g}", number);
}

/// What is too much about a bed of so many cells and a run of so many steps; empty where nothing
/// is.
std::string excess(const Scene& scene, std::int64_t cells, std::int64_t steps) {
    const auto text = [](double number, const char* unit, double most) {
        return fmt::format("{} {} are more than the {} allowed to scenes of unknown origin{}",
                           amount(number), unit, amount(most), lifted);
    };
    const auto most_cells = static_cast<double>(trust_limits.cells);
    const double size = size_of(scene, cells);
    if (size > most_cells) return text(size, "cells", most_cells);
    if (steps > trust_limits.steps)
        return text(static_cast<double>(steps), "steps", static_cast<double>(trust_limits.steps));
    const double work = size * static_cast<double>(steps);
    if (work > trust_limits.cell_steps) return text(work, "cell-steps", trust_limits.cell_steps);
    const double grains =
        static_cast<double>(factor_of(scene, "model.grains_per_step")) * static_cast<double>(steps);
    if (grains > trust_limits.grains) return text(grains, "grains", trust_limits.grains);
    return {};
}

}  // namespace

void check_limits(const Scene& scene, Faults& faults) {
    if (scene.trusted) return;
    const auto refuse = [&](const char* key, const std::string& what) {
        faults.add(InputError(scene.at(key) + what));
    };
    const bool from_file = !scene.bed.file.empty();
    const std::int64_t rows = factor_of(scene, "model.nz") > 1 ? 1 : scene.grid.ny;
    const std::string too_much =
        excess(scene, from_file ? 1 : scene.grid.nx * rows, scene.run.steps);
    if (!too_much.empty())
        refuse(too_much.find(" cells ") != std::string::npos ? "grid.nx" : "run.steps", too_much);
    const ImageSettings& image = scene.view.image;
    const std::int64_t samples =
        image.width * image.height * image.supersampling * image.supersampling;
    if (samples > trust_limits.samples) {
        refuse("image.width",
               fmt::format(
                   "pictures of {} samples are larger than the {} allowed to scenes of unknown "
                   "origin{}",
                   with_commas(samples), with_commas(trust_limits.samples), lifted));
    }
    const std::int64_t frames =
        scene.run.steps <= trust_limits.steps ? frame_schedule(scene).count() : 0;
    if (frames > trust_limits.frames) {
        refuse("frames.every",
               fmt::format("{} frames are more than the {} allowed to scenes of unknown origin{}",
                           with_commas(frames), with_commas(trust_limits.frames), lifted));
    }
}

void check_limits(const Scene& scene, std::int64_t cells, std::int64_t steps) {
    if (scene.trusted) return;
    const std::string too_much = excess(scene, cells, steps);
    if (!too_much.empty()) throw InputError(scene.at("bed.file") + too_much);
}

void check_trust(const Scene& scene, const std::string& key, const std::filesystem::path& file) {
    if (scene.trusted || scene.set_on_command_line(key)) return;
    const bool listed = scene.bed_hashes != nullptr;
    const std::string why = listed ? why_trust_is_needed(file) : why_trust_is_needed_by_name(file);
    if (why.empty()) return;
    throw InputError(fmt::format(
        "{}{} is read only with --trust, since {}{}", scene.at(key), file.string(), why,
        listed ? fmt::format(": fumon again --trust {}", scene.source) : std::string()));
}

bool is_own_file(const Scene& scene, const std::string& key) {
    return scene.trusted || scene.set_on_command_line(key);
}

void check_named_file(const Scene& scene, const std::string& key, const std::string& written,
                      const std::filesystem::path& file) {
    const bool mine = is_own_file(scene, key);
    const bool listed = !scene.bed_hashes || scene.set_on_command_line(key) ||
                        std::ranges::any_of(*scene.bed_hashes, [&](const std::string& hash) {
                            return has_grid_hash(file, hash);
                        });
    if (!listed || (!mine && !scene.bed_hashes)) {
        throw InputError(
            fmt::format("{}{} is not one of the files whose SHA-256 the metadata lists, is "
                        "missing, or has changed",
                        scene.at(key), file.string()));
    }
    check_trust(scene, key, file);
    std::error_code fault;
    if (mine && !std::filesystem::exists(file, fault)) {
        throw InputError(fmt::format("{}{} \"{}\" does not exist (looked for {})", scene.at(key),
                                     key, written, file.string()));
    }
}

bool may_report_bed(const Scene& scene) {
    return scene.trusted || scene.set_on_command_line("bed.file");
}

}  // namespace fumon
