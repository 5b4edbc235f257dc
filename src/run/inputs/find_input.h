#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "scene/initial_bed.h"
#include "scene/scene.h"

namespace fumon {

/// Finds an input of a picture, movie or run (`what`, at `place`): first the recorded path from the
/// working folder, then below the folder of `place` or one of its parents. Throws InputError if no
/// file there has the recorded content with what lies beside it (grid_hash); it does not say
/// whether there is another one, since a picture of others may name any path.
std::filesystem::path find_input(const InputFile& input, const std::filesystem::path& place,
                                 std::string_view what);

/// Puts the inputs of a run, as find_input() finds them, in the place of the files that its scene
/// names (input_keys); a drape or layer that the command line names stays.
void find_inputs(Scene& scene, const std::vector<InputFile>& inputs,
                 const std::filesystem::path& place, std::string_view what);

/// The hashes of inputs, for Scene::bed_hashes.
std::shared_ptr<const std::vector<std::string>> hashes_of(const std::vector<InputFile>& inputs);

}  // namespace fumon
