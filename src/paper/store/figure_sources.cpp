#include "paper/store/figure_sources.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/error.h"
#include "files/input_file.h"
#include "files/terrain/grid_hash.h"
#include "run/inputs/find_input.h"
#include "scene/input_maps.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

std::string name_of(const fs::path& file) {
    return file.lexically_normal().string();
}

}  // namespace

FigureSources::FigureSources(std::vector<SourceText> texts, std::vector<InputFile> inputs,
                             FindInput find, bool trusted, std::string version)
    : again_(true),
      trusted_(trusted),
      version_(std::move(version)),
      inputs_(std::move(inputs)),
      find_(std::move(find)) {
    for (SourceText& text : texts) {
        const std::string name = text.path;
        texts_[name] = std::move(text);
    }
}

const SourceText& FigureSources::text(const fs::path& file) {
    const std::string name = name_of(file);
    const auto known = texts_.find(name);
    if (known != texts_.end()) return known->second;
    if (again_) {
        throw InputError(
            fmt::format("{}: is not among the files that the figure was made from", name));
    }
    return texts_[name] = {name, read_input_file(name)};
}

SceneText FigureSources::scene(const fs::path& file) {
    const SourceText& source = text(file);
    return {source.text,
            source.path,
            fs::path(source.path).parent_path(),
            trusted_,
            again_ ? hashes_of(inputs_) : nullptr,
            version_};
}

std::vector<SourceText> FigureSources::all() const {
    std::vector<SourceText> texts;
    for (const auto& [name, text] : texts_) texts.push_back(text);
    return texts;
}

void FigureSources::find_inputs(Scene& scene) const {
    if (!again_) return;
    for (const InputKey& key : input_keys(scene))
        find(
            scene.set_on_command_line(key.path) ? fs::path(*key.file) : scene.directory / *key.file,
            *key.file);
}

std::string FigureSources::profile(const Scene& scene) const {
    const fs::path named(scene.figure.icc_profile);
    std::string file =
        (scene.set_on_command_line("figure.icc_profile") ? named : scene.directory / named)
            .lexically_normal()
            .string();
    if (again_) find(file, file);
    return file;
}

/// Of what a figure made again reads.
void FigureSources::find(const fs::path& named, std::string& file) const {
    const std::string name = name_of(named);
    for (const InputFile& input : inputs_) {
        if (name_of(input.path) == name) {
            file = fs::absolute(find_(input)).string();
            return;
        }
    }
    const bool found_before =
        std::any_of(inputs_.begin(), inputs_.end(),
                    [&](const InputFile& input) { return has_grid_hash(name, input.hash); });
    if (found_before) return;
    throw InputError(fmt::format("{}: is not among the files that the figure was made from", name));
}

InputFile FigureSources::as_first_named(const InputFile& input) const {
    for (const InputFile& first : inputs_) {
        if (first.hash == input.hash) return first;
    }
    return {name_of(input.path), input.hash};
}

}  // namespace fumon
