#include "run/inputs/find_input.h"

#include <fmt/format.h>

#include <exception>
#include <system_error>
#include <vector>

#include "base/error.h"
#include "files/hash.h"
#include "files/terrain/grid_hash.h"
#include "scene/beds/memory_bed.h"
#include "scene/input_maps.h"

namespace fumon {

namespace fs = std::filesystem;

namespace {

/// Whether a file has a hash but for what lies beside it.
bool is_that_file_alone(const fs::path& file, const std::string& hash) {
    std::error_code fault;
    if (!fs::is_regular_file(file, fault)) return false;
    try {
        return hex(file_hash(file)) == hash;
    } catch (const std::exception&) {
        return false;  // it cannot be read
    }
}

}  // namespace

fs::path find_input(const InputFile& input, const fs::path& place, std::string_view what) {
    if (is_memory_bed(input.path))
        throw InputError(fmt::format("{}: {}", place.string(), missing_memory_bed(input.path)));
    std::vector<fs::path> candidates{input.path};
    if (fs::path(input.path).is_relative()) {
        for (fs::path folder = fs::absolute(place).parent_path();; folder = folder.parent_path()) {
            candidates.push_back(folder / input.path);
            if (folder == folder.parent_path()) break;
        }
    }
    for (const fs::path& candidate : candidates) {
        if (has_grid_hash(candidate, input.hash)) return candidate;
    }
    for (const fs::path& candidate : candidates) {
        if (!is_that_file_alone(candidate, input.hash)) continue;
        throw InputError(
            fmt::format("{}: {} has not changed since the {} was made, but files that belong to it "
                        "(a mask, a .prj …) are new or were not recorded; move them away",
                        place.string(), input.path, what));
    }
    throw InputError(
        fmt::format("{}: {} as it was when the {} was made (SHA-256 {}…) is missing; restore it, "
                    "copy it beside the {}, or work in the folder to which the path is relative",
                    place.string(), input.path, what, input.hash.substr(0, 12), what));
}

std::shared_ptr<const std::vector<std::string>> hashes_of(const std::vector<InputFile>& inputs) {
    auto hashes = std::make_shared<std::vector<std::string>>();
    for (const InputFile& input : inputs) hashes->push_back(input.hash);
    return hashes;
}

void find_inputs(Scene& scene, const std::vector<InputFile>& inputs, const fs::path& place,
                 std::string_view what) {
    const std::vector<InputKey> keys = input_keys(scene);
    for (std::size_t k = 0; k < keys.size() && k < inputs.size(); ++k) {
        const bool over_bed = keys[k].path == "look.drape" || keys[k].path.starts_with("layer.");
        const bool another = over_bed && scene.set_on_command_line(keys[k].path);
        if (!another) *keys[k].file = find_input(inputs[k], place, what).string();
    }
}

}  // namespace fumon
