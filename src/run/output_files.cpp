#include "run/output_files.h"

#include <fmt/format.h>

#include "base/error.h"
#include "files/atomic_file.h"
#include "files/hash.h"
#include "files/terrain/geotiff.h"
#include "files/terrain/terrain_format.h"
#include "outputs/output_claims.h"
#include "picture/exr.h"
#include "picture/png.h"
#include "render/view/map_frame.h"
#include "run/frame_painter.h"
#include "run/picture_text.h"
#include "run/pipeline.h"

namespace fumon {

namespace {

constexpr const char* world_files_key = "output.world_files";
constexpr const char* geotiff_frames_key = "output.geotiff_frames";
constexpr std::string_view geotiff_ending = ".tif";

}  // namespace

FrameRecord write_frame(const RunFolder* folder, const RunParts& parts, const Picture& picture,
                        const PictureFacts& facts) {
    const Snapshot& snapshot = *picture.snapshot;
    const Sha256 pixels = pixel_hash(*picture.image);
    const std::string& resolved = picture.resolved ? *picture.resolved : facts.resolved;
    Sha256 written{};
    const auto write = [&](const std::filesystem::path& file, const PictureText& texts) {
        const std::vector<std::uint8_t> bytes =
            encode_png(*picture.image, facts.scene.view.image.dots_per_inch, texts);
        written = bytes_hash(bytes);
        write_file(file, bytes);
    };
    if (parts.frames) {
        if (picture.layers) {  // first: a frame that is there is whole
            write_file(folder->frame(picture.number).replace_extension(exr_ending.front()),
                       encode_exr(*picture.layers, facts.scene.view.image.dots_per_inch,
                                  picture_text(resolved, facts.scene, snapshot.step, facts.inputs,
                                               layers_hash(*picture.layers), facts.environment)));
        }
        write(folder->frame(picture.number), picture_text(resolved, facts.scene, snapshot.step,
                                                          facts.inputs, pixels, facts.environment));
        write_map_files(facts.scene, snapshot, *picture.image, folder->frame(picture.number));
    }
    if (parts.movie_frames) {  // of which one to go on from must tell its colours
        write(folder->movie_frame(picture.number),
              picture.resolved ? picture_text(resolved, facts.scene, snapshot.step, facts.inputs,
                                              pixels, facts.environment)
                               : PictureText{});
    }
    return {picture.number, snapshot.step, snapshot.time, pixels, written};
}

void check_map_files(const Scene& scene, const Snapshot& first) {
    if (scene.output.exr_frames) check_layers(scene, first);
    if (scene.output.world_files) map_frame(scene.view, first, world_files_key);
    if (!scene.output.geotiff_frames) return;
    map_frame(scene.view, first, geotiff_frames_key);
    if (const std::string missing = find_written_format("geotiff")->missing(); !missing.empty())
        throw KeyError(geotiff_frames_key, fmt::format("{} {}", geotiff_frames_key, missing));
}

std::vector<std::filesystem::path> map_file_names(const Scene& scene,
                                                  const std::filesystem::path& picture) {
    std::vector<std::filesystem::path> names;
    const auto add = [&](std::string_view ending) {
        names.push_back(std::filesystem::path(picture).replace_extension(ending));
    };
    if (scene.output.world_files) {
        for (const WorldFile& file : world_files({}, small_ending(picture))) add(file.ending);
    }
    if (scene.output.geotiff_frames) add(geotiff_ending);
    return names;
}

void write_map_files(const Scene& scene, const Snapshot& snapshot, const Image& image,
                     const std::filesystem::path& picture) {
    const auto write = [&](std::string_view ending, const std::string& bytes) {
        write_file(std::filesystem::path(picture).replace_extension(ending), bytes);
    };
    if (scene.output.world_files) {
        for (const WorldFile& file :
             world_files(map_frame(scene.view, snapshot, world_files_key), small_ending(picture)))
            write(file.ending, file.text);
    }
    if (!scene.output.geotiff_frames) return;
    const MapFrame frame = map_frame(scene.view, snapshot, geotiff_frames_key);
    GeoReference place;
    place.west = frame.west;
    place.south = frame.north - frame.pixel_y * image.height;
    place.dx = frame.pixel_x;
    place.dy = frame.pixel_y;
    place.crs = frame.crs;
    write(geotiff_ending, geotiff_picture(image, place));
}

Image read_frame(const RunFolder& folder, const RunParts& parts, const FrameRecord& frame) {
    const std::filesystem::path file =
        parts.frames ? folder.frame(frame.number) : folder.movie_frame(frame.number);
    Image image = read_png(file);
    if (pixel_hash(image) == frame.pixels) return image;
    throw Error(
        fmt::format("{}: its pixels are not those that the run wrote, so the movie cannot be "
                    "started again; restore the old file",
                    file.string()));
}

BedRecord write_bed(const RunFolder& folder, const Snapshot& snapshot,
                    const std::vector<std::string>& formats) {
    BedRecord bed{snapshot.step, {}};
    for (const TerrainBytes& file : bed_files(snapshot, formats)) {
        bed.files.push_back({file.ending, text_hash(file.bytes)});
        write_file(folder.bed(snapshot.step, file.ending), file.bytes);
    }
    return bed;
}

void sync_to_disk(const RunFolder& folder, const RunParts& parts, const RunOutcome& outcome) {
    if (parts.frames) {
        for (std::int64_t frame = 0; frame < outcome.frames; ++frame)
            sync_file(folder.frame(frame));
        sync_folder_of(folder.frame(0));
    }
    for (const BedRecord& bed : outcome.beds) {
        for (const BedRecord::File& file : bed.files) sync_file(folder.bed(bed.step, file.ending));
    }
    if (parts.beds) sync_folder_of(folder.bed(0, ""));
    const RecordPaths records = folder.records();
    if (outcome.recorded.measurements) sync_file(records.measurements);
    if (outcome.recorded.avalanches) sync_file(records.avalanches);
    if (outcome.movie.frames > 0) sync_file(folder.movie());
    sync_folder_of(folder.manifest());
}

}  // namespace fumon
