#include "film/script/layer_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "base/error.h"
#include "files/hash.h"
#include "files/terrain/grid_hash.h"
#include "keys/setting.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

/// The value of such a setting.
std::string written_file(const Override& setting) {
    return parse_setting(setting).value().value_or(std::string());
}

}  // namespace

bool names_layer_file(const Override& setting) {
    return setting.path.starts_with("layer.") && setting.path.ends_with(".file");
}

fs::path layer_file(const Override& setting, const LayerFiles& found) {
    const std::string written = written_file(setting);
    if (const auto known = found.find(written); known != found.end()) return known->second;
    if (setting.place.starts_with("--set")) return written;
    const fs::path film(setting.place.substr(0, setting.place.rfind(':')));
    std::string ending = film.extension().string();
    for (char& letter : ending)
        if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
    if (ending != ".toml") {
        throw InputError(
            fmt::format("{}: {}: a film within a movie or picture reads no files; write "
                        "it to a film file of your own",
                        setting.place, setting.path));
    }
    return fs::absolute(film.parent_path() / written);
}

std::vector<InputFile> layer_inputs(const Film& film) {
    std::vector<InputFile> inputs;
    const auto add = [&](const std::vector<Override>& looks) {
        for (const Override& setting : looks) {
            if (!names_layer_file(setting)) continue;
            const std::string written = written_file(setting);
            const bool listed =
                std::ranges::find(inputs, written, &InputFile::path) != inputs.end();
            if (written.empty() || listed) continue;
            inputs.push_back({written, hex(grid_hash(layer_file(setting, film.found_layers)))});
        }
    };
    const auto add_all = [&](const Film& of) {
        add(of.looks);
        for (const Shot& shot : of.shots) add(shot.looks);
    };
    add_all(film);
    for (const Excerpt& excerpt : film.excerpts)
        if (excerpt.read) add_all(*excerpt.read);
    return inputs;
}

}  // namespace fumon
