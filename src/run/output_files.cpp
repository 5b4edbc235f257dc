#include "run/output_files.h"

#include <fmt/format.h>

#include "base/error.h"
#include "files/atomic_file.h"
#include "files/hash.h"
#include "files/terrain/terrain_format.h"
#include "picture/png.h"
#include "render/view/map_frame.h"
#include "run/picture_text.h"
#include "run/pipeline.h"

namespace fumon {

FrameRecord write_frame(const RunFolder* folder, const RunParts& parts, const Picture& picture,
                        const PictureFacts& facts) {
    const Snapshot& snapshot = *picture.snapshot;
    const Sha256 pixels = pixel_hash(*picture.image);
    Sha256 written{};
    const auto write = [&](const std::filesystem::path& file, const PictureText& texts) {
        const std::vector<std::uint8_t> bytes =
            encode_png(*picture.image, facts.scene.view.image.dots_per_inch, texts);
        written = bytes_hash(bytes);
        write_file(file, bytes);
    };
    if (parts.frames) {
        write(folder->frame(picture.number),
              picture_text(facts.resolved, facts.scene, snapshot.step, facts.inputs, pixels,
                           facts.environment));
        if (facts.scene.output.world_files)
            write_world_files(facts.scene.view, snapshot, folder->frame(picture.number));
    }
    if (parts.movie_frames) write(folder->movie_frame(picture.number), {});
    return {picture.number, snapshot.step, snapshot.time, pixels, written};
}

std::vector<std::filesystem::path> world_file_names(const std::filesystem::path& picture) {
    std::vector<std::filesystem::path> names;
    for (const WorldFile& file : world_files({}))
        names.push_back(std::filesystem::path(picture).replace_extension(file.ending));
    return names;
}

void write_world_files(const View& view, const Snapshot& snapshot,
                       const std::filesystem::path& picture) {
    for (const WorldFile& file : world_files(map_frame(view, snapshot)))
        write_file(std::filesystem::path(picture).replace_extension(file.ending), file.text);
}

Image read_frame(const RunFolder& folder, const RunParts& parts, const FrameRecord& frame) {
    const std::filesystem::path file =
        parts.frames ? folder.frame(frame.number) : folder.movie_frame(frame.number);
    Image image = read_png(file);
    if (pixel_hash(image) == frame.pixels) return image;
    throw Error(
        fmt::format("{}: its pixels are not those that the run wrote, so the movie cannot "
                    "be begun again; bring the old file back",
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

void put_on_disk(const RunFolder& folder, const RunParts& parts, const RunOutcome& outcome) {
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
