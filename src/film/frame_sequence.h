#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace fumon {

/// Whether a file's name stands for one picture a frame: it has the place of the frame's number,
/// "%d" or "%05d", once.
bool is_frame_sequence(const std::filesystem::path& file);

/// Whether such pictures are light as OpenEXR, by their name.
bool holds_light(const std::filesystem::path& file);

/// A name of one picture a frame where it stands for a folder: FOLDER/frame_%05d.png; else as it
/// is.
std::filesystem::path sequence_name(const std::filesystem::path& file);

/// The file of a frame: film_%05d.png is film_00012.png.
std::filesystem::path sequence_file(const std::filesystem::path& file, std::int64_t frame);

}  // namespace fumon
