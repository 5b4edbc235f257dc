#include "scene/find_input.h"

#include <fmt/format.h>

#include <system_error>
#include <vector>

#include "base/error.h"
#include "files/hash.h"

namespace fumon {

namespace fs = std::filesystem;

fs::path find_input(const InputFile& input, const fs::path& place, std::string_view what) {
    std::vector<fs::path> candidates{input.path};
    if (fs::path(input.path).is_relative()) {
        for (fs::path folder = fs::absolute(place).parent_path();; folder = folder.parent_path()) {
            candidates.push_back(folder / input.path);
            if (folder == folder.parent_path()) break;
        }
    }
    fs::path changed;
    for (const fs::path& candidate : candidates) {
        std::error_code fault;
        if (!fs::is_regular_file(candidate, fault)) continue;
        if (hex(file_hash(candidate)) == input.hash) return candidate;
        if (changed.empty()) changed = candidate;
    }
    if (!changed.empty()) {
        throw InputError(fmt::format(
            "{}: {} has changed since the {} was made (SHA-256 then {}…); bring the old "
            "file back",
            place.string(), changed.string(), what, input.hash.substr(0, 12)));
    }
    throw InputError(
        fmt::format("{}: {} (SHA-256 {}…), which the {} was made from, is not there; run this "
                    "in the folder from which the path leads to it",
                    place.string(), input.path, input.hash.substr(0, 12), what));
}

}  // namespace fumon
