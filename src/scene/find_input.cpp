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
    for (const fs::path& candidate : candidates) {
        if (has_hash(candidate, input.hash)) return candidate;
    }
    throw InputError(
        fmt::format("{}: {} as it was when the {} was made (SHA-256 {}…) is not there; bring it "
                    "back, or run this in the folder from which the path leads to it",
                    place.string(), input.path, what, input.hash.substr(0, 12)));
}

std::shared_ptr<const std::vector<std::string>> hashes_of(const std::vector<InputFile>& inputs) {
    auto hashes = std::make_shared<std::vector<std::string>>();
    for (const InputFile& input : inputs) hashes->push_back(input.hash);
    return hashes;
}

bool has_hash(const fs::path& file, const std::string& hash) {
    std::error_code fault;
    if (!fs::is_regular_file(file, fault)) return false;
    try {
        return hex(file_hash(file)) == hash;
    } catch (const Error&) {
        return false;  // it cannot be read
    }
}

}  // namespace fumon
