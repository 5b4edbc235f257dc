#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/grid.h"
#include "models/shared/model.h"
#include "scene/scene.h"

namespace fumon {

/// A file that a scene reads, as a picture's metadata records it.
struct InputFile {
    std::string path;  ///< as reached from the working folder
    std::string hash;  ///< SHA-256, hexadecimal
};

/// What a run starts from.
struct InitialBed {
    Grid bed;  ///< model heights
    Mask nodata;
    WorldScale scale;
    std::vector<InputFile> inputs;  ///< by the order of input_keys()
    std::vector<CellMap> maps{};    ///< what [[map]] gives, see add_maps()
    std::string note;  ///< what the user should hear (degrees converted, …); or empty
};

/// The kind of bed that a scene starts from, where bed.kind is "auto" too.
BedKind bed_kind(const Scene& scene);

/// Where the terrain file of a scene lies: as it stands on the command line, else as seen from the
/// scene's folder.
std::filesystem::path bed_path(const Scene& scene);

/// Builds the initial bed of a scene: flat, uniform noise from the scene's seed, or a terrain file,
/// whose metres are divided by the height unit. Throws InputError located at the scene's key when a
/// file is unreadable or malformed or does not fit grid.nx, grid.ny or grid.cell_size.
InitialBed make_initial_bed(const Scene& scene);

}  // namespace fumon
