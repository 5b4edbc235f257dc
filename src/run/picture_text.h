#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "files/hash.h"
#include "picture/environment.h"
#include "picture/png.h"
#include "run/frame_list.h"
#include "run/frame_painter.h"
#include "scene/initial_bed.h"
#include "scene/scene.h"

namespace fumon {

/// The keyword of a text that holds the version of the fumon that wrote it.
inline constexpr const char* version_keyword = "fumon:version";

/// A picture's record of how it was made.
struct PictureOrigin {
    std::string scene;  ///< resolved, as TOML; its bed.file as reached from the working folder
    std::int64_t step = 0;
    std::vector<InputFile> inputs;
    std::string version;                              ///< of the fumon that made it
    std::string pixels_hash;                          ///< SHA-256 of the raw pixels, hexadecimal
    std::optional<RenderingEnvironment> environment;  ///< none in pictures of older versions
    bool is_movie = false;
    bool is_exr = false;
    std::string ending;   ///< of such a file: ".png", ".jpg", ".webp", ".tif", ".exr", ".mp4"
    std::string encoder;  ///< of a movie: what encoded its frames
    std::string results;  ///< of a still of another model's results: what is recorded of them
};

/// The scene with every default written out and its input files named as reached from the working
/// folder, or by their names alone where that would tell of folders of this machine.
std::string resolved_scene(const Scene& scene, const std::vector<InputFile>& inputs);

/// The texts to write into a picture: Title, Software, and fumon's own (fumon:scene, fumon:seed,
/// fumon:step, fumon:version, fumon:inputs, fumon:pixels-sha256, fumon:environment).
PictureText picture_text(const std::string& resolved, const Scene& scene, std::int64_t step,
                         const std::vector<InputFile>& inputs, const Sha256& pixels,
                         const RenderingEnvironment& environment);

/// The same of a picture that is drawn of another model's results, with what is recorded of them
/// (fumon:results); as they are where that is empty.
PictureText of_results(PictureText texts, const std::string& results);

/// The texts of a movie: those of its last frame, but fumon:pixels-sha256 is the SHA-256 over the
/// pixel hashes of all frames, and fumon:encoder says what encoded them.
PictureText movie_text(const std::string& resolved, const Scene& scene,
                       const std::vector<InputFile>& inputs, const FrameList& frames,
                       const RenderingEnvironment& environment);

/// Reads them back. Throws InputError when the file is neither PNG, JPEG, WebP, OpenEXR nor MP4 or
/// not of fumon's making.
PictureOrigin read_origin(const std::filesystem::path& picture);

}  // namespace fumon
