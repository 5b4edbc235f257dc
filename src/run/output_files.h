#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/image.h"
#include "picture/environment.h"
#include "run/run_folder.h"
#include "run/stepper.h"
#include "run/written_outputs.h"
#include "scene/initial_bed.h"
#include "scene/scene.h"

namespace fumon {

struct RunOutcome;

/// A frame that was drawn.
struct Picture {
    std::int64_t number = 0;
    SharedSnapshot snapshot;
    std::shared_ptr<const Image> image;
    std::shared_ptr<const LayeredImage> layers;  ///< null: none are asked for
    /// The scene as TOML that makes this picture alone, where it is not the run's: with the colours
    /// that the run's first pictures gave it.
    std::shared_ptr<const std::string> resolved{};
};

/// What a run's pictures say of their making.
struct PictureFacts {
    const std::string& resolved;  ///< the scene as TOML
    const Scene& scene;
    const std::vector<InputFile>& inputs;
    const RenderingEnvironment& environment;
};

/// Writes a frame into the folders that a run has for it, if any; `folder` may be nullptr where
/// there are none. Throws Error.
FrameRecord write_frame(const RunFolder* folder, const RunParts& parts, const Picture& picture,
                        const PictureFacts& facts);

/// Throws KeyError, as map_frame() and check_layers(), where a scene asks for files beside its
/// pictures that this bed cannot have, or fumon not write.
void check_map_files(const Scene& scene, const Snapshot& first);

/// The files that a scene asks for beside a picture: picture.pgw and picture.png.aux.xml
/// (output.world_files), picture.tif (output.geotiff_frames), picture.exr (output.exr_frames).
std::vector<std::filesystem::path> map_file_names(const Scene& scene,
                                                  const std::filesystem::path& picture);

/// Writes them. Throws KeyError as map_frame(), Error.
void write_map_files(const Scene& scene, const Snapshot& snapshot, const Image& image,
                     const std::filesystem::path& picture);

/// Reads a frame that the run wrote before its checkpoint. Throws Error if its pixels have changed.
Image read_frame(const RunFolder& folder, const RunParts& parts, const FrameRecord& frame);

/// Writes the bed of a snapshot in terrain formats of these names, in metres where there are
/// metres. Throws Error.
BedRecord write_bed(const RunFolder& folder, const Snapshot& snapshot,
                    const std::vector<std::string>& formats);

/// Puts all that a complete run has written on disk, before its manifest says that it is complete.
/// Throws Error.
void sync_to_disk(const RunFolder& folder, const RunParts& parts, const RunOutcome& outcome);

}  // namespace fumon
