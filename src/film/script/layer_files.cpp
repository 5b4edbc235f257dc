#include "film/script/layer_files.h"

#include <fmt/format.h>

#include <cstddef>
#include <memory>
#include <string>
#include <utility>

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

void for_each_layer(Film& film, const UseLayer& use) {
    const auto each = [&](std::vector<Override>& looks, const std::string& owner) {
        for (Override& setting : looks)
            if (names_layer_file(setting) && !written_file(setting).empty())
                use(owner + setting.path, setting);
    };
    const auto each_of = [&](Film& of, const std::string& owner) {
        each(of.looks, owner);
        for (std::size_t i = 0; i < of.shots.size(); ++i)
            each(of.shots[i].looks, fmt::format("{}shot.{}.", owner, i));
    };
    each_of(film, "");
    for (std::size_t i = 0; i < film.excerpts.size(); ++i) {
        Excerpt& excerpt = film.excerpts[i];
        if (!excerpt.read) continue;
        Film read = *excerpt.read;
        each_of(read, fmt::format("excerpt.{}.", i));
        excerpt.read = std::make_shared<const Film>(std::move(read));
    }
}

bool is_given_now(const Override& setting) {
    return setting.place.starts_with("--set");
}

fs::path layer_file(const Override& setting, const LayerFiles& found, const std::string& key) {
    const std::string written = written_file(setting);
    if (is_given_now(setting)) return fs::absolute(written);
    for (const std::string& name : {key, written})
        if (const auto known = found.find(name); known != found.end()) return known->second.file;
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

std::vector<LayerRecord> layer_records(Film film) {
    std::vector<LayerRecord> records;
    for_each_layer(film, [&](const std::string& key, const Override& setting) {
        const fs::path file = layer_file(setting, film.found_layers, key);
        const std::string written = written_file(setting);
        const auto found = film.found_layers.find(key);
        if (found != film.found_layers.end() && !is_given_now(setting)) {
            records.push_back({key, {written, hex(grid_hash(file))}, found->second.from});
            return;
        }
        const std::string from = file.lexically_relative(fs::current_path()).generic_string();
        const bool is_below = !from.empty() && !from.starts_with("..") && from != written;
        records.push_back({key, {written, hex(grid_hash(file))}, is_below ? from : ""});
    });
    return records;
}

Film with_whole_layer_paths(Film film) {
    LayerFiles whole;
    for_each_layer(film, [&](const std::string& key, Override& setting) {
        const std::string file = layer_file(setting, film.found_layers, key).string();
        setting.value = file;  // a bare string: no TOML begins with a slash
        whole[file] = {file};
    });
    film.found_layers = std::move(whole);
    return film;
}

}  // namespace fumon
